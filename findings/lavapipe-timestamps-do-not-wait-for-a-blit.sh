#!/usr/bin/env bash
# Package: mesa-vulkan-drivers 22.3.6-1+deb12u2 with libllvm15 1:15.0.6-4+b1 (Debian 12).
# Behaviour: a timestamp that waits for ALL_COMMANDS, written after a large blit in the same command buffer, is taken
# before the blit has ended. With a pipeline barrier between the two it is taken after it.
# Expected: the stage ALL_COMMANDS is what a timestamp waits for; a barrier orders commands, not clocks.
# Why it matters: a quality setting that follows the device's own clock believes that a slow software picture takes a
# fraction of its time. Put the frame's last timestamp after its last barrier, and compare with the wall's time once.
# Seen:
#   without a barrier: under half of the wall's time; with one: over nine tenths
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download mesa-vulkan-drivers=22.3.6-1+deb12u2 libllvm15=1:15.0.6-4+b1 \
    libvulkan1=1.3.239.0-1 libvulkan-dev=1.3.239.0-1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >blit.c <<'CODE'
// Prints the share of the wall's time that two timestamps around a blit tell, without a barrier the least of five, with one the most.
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <vulkan/vulkan.h>
#define SIDE 4096
static void need(VkResult result, int line) {
    if (result != VK_SUCCESS) { fprintf(stderr, "line %d: VkResult %d\n", line, result); exit(2); }
}
#define NEED(call) need(call, __LINE__)
static double now_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1e3 + now.tv_nsec * 1e-6;
}
static VkDevice device;
static VkImage image(int side) {
    VkImage made;
    NEED(vkCreateImage(device, &(VkImageCreateInfo){VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO, .imageType = VK_IMAGE_TYPE_2D, .format = VK_FORMAT_R8G8B8A8_UNORM, .extent = {side, side, 1}, .mipLevels = 1, .arrayLayers = 1, .samples = VK_SAMPLE_COUNT_1_BIT, .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}, NULL, &made));
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device, made, &needs);
    VkDeviceMemory memory;
    NEED(vkAllocateMemory(device, &(VkMemoryAllocateInfo){VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size}, NULL, &memory));
    NEED(vkBindImageMemory(device, made, memory, 0));
    return made;
}
static void barrier(VkCommandBuffer command, VkImage image, VkImageLayout from, VkImageLayout to) {
    vkCmdPipelineBarrier(command, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, NULL, 0, NULL, 1, &(VkImageMemoryBarrier){VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER, .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT, .dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT, .oldLayout = from, .newLayout = to, .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED, .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED, .image = image, .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}});
}
int main(void) {
    VkInstance instance;
    VkApplicationInfo app = {VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_1};
    NEED(vkCreateInstance(&(VkInstanceCreateInfo){VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &app}, NULL, &instance));
    uint32_t one = 1;
    VkPhysicalDevice physical;
    NEED(vkEnumeratePhysicalDevices(instance, &one, &physical));
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    const float priority = 1;
    VkDeviceQueueCreateInfo queues = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    NEED(vkCreateDevice(physical, &(VkDeviceCreateInfo){VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .queueCreateInfoCount = 1, .pQueueCreateInfos = &queues}, NULL, &device));
    VkQueue queue;
    vkGetDeviceQueue(device, 0, 0, &queue);
    VkImage small = image(SIDE / 2), large = image(SIDE);
    VkCommandPool commands;
    NEED(vkCreateCommandPool(device, &(VkCommandPoolCreateInfo){VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO}, NULL, &commands));
    VkQueryPool times;
    NEED(vkCreateQueryPool(device, &(VkQueryPoolCreateInfo){VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO, .queryType = VK_QUERY_TYPE_TIMESTAMP, .queryCount = 2}, NULL, &times));
    for (int with_barrier = 0; with_barrier < 2; ++with_barrier) {
        double share = with_barrier ? 0 : 1e9;
        for (int run = 0; run < 5; ++run) {
            VkCommandBuffer command;
            NEED(vkAllocateCommandBuffers(device, &(VkCommandBufferAllocateInfo){VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, .commandPool = commands, .commandBufferCount = 1}, &command));
            NEED(vkBeginCommandBuffer(command, &(VkCommandBufferBeginInfo){VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO}));
            vkCmdResetQueryPool(command, times, 0, 2);
            barrier(command, small, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
            barrier(command, large, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
            vkCmdWriteTimestamp(command, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, times, 0);
            VkImageBlit part = {{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1}, {{0, 0, 0}, {SIDE / 2, SIDE / 2, 1}}, {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1}, {{0, 0, 0}, {SIDE, SIDE, 1}}};
            vkCmdBlitImage(command, small, VK_IMAGE_LAYOUT_GENERAL, large, VK_IMAGE_LAYOUT_GENERAL, 1, &part, VK_FILTER_LINEAR);
            if (with_barrier) barrier(command, large, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL);
            vkCmdWriteTimestamp(command, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, times, 1);
            NEED(vkEndCommandBuffer(command));
            const double began_ms = now_ms();
            NEED(vkQueueSubmit(queue, 1, &(VkSubmitInfo){VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &command}, VK_NULL_HANDLE));
            NEED(vkDeviceWaitIdle(device));
            const double wall_ms = now_ms() - began_ms;
            uint64_t ticks[2];
            NEED(vkGetQueryPoolResults(device, times, 0, 2, sizeof ticks, ticks, sizeof *ticks, VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT));
            const double told_ms = (ticks[1] - ticks[0]) * properties.limits.timestampPeriod * 1e-6;
            fprintf(stderr, "%s: %.1f ms of %.1f\n", with_barrier ? "with" : "without", told_ms, wall_ms);
            if (run > 0 && (told_ms / wall_ms > share) == with_barrier) share = told_ms / wall_ms;
        }
        printf("%s%s", with_barrier ? "; with one: " : "without a barrier: ",
               share > 0.9 ? "over nine tenths" : share < 0.5 ? "under half of the wall's time" : "between");
    }
    return 0;
}
CODE
gcc -O1 -Iusr/include blit.c -o blit "$libraries/libvulkan.so.1"
cat >lavapipe.json <<ICD
{"file_format_version": "1.0.0", "ICD": {"library_path": "$libraries/libvulkan_lvp.so", "api_version": "1.3.230"}}
ICD
saw=$(MESA_SHADER_CACHE_DISABLE=true VK_ICD_FILENAMES="$PWD/lavapipe.json" LD_LIBRARY_PATH="$libraries" ./blit)
echo "saw: $saw"
[ "$saw" = "without a barrier: under half of the wall's time; with one: over nine tenths" ]
