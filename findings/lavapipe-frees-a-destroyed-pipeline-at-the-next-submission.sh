#!/usr/bin/env bash
# Package: mesa-vulkan-drivers 22.3.6-1+deb12u2 (Debian 12), software Vulkan (lavapipe).
# Behaviour: vkDestroyPipeline keeps the pipeline with its memory until something is submitted to the queue: of 2,000 compute
# pipelines, each destroyed before the next is made, all are held at the end. One empty submission frees them.
# Expected: the memory is free on return, as for every other object: no queue has ever seen these pipelines.
# Why it matters: a program that compiles its variants before the first frame, a shader editor or a kiosk that shows a still
# picture grows by tens to hundreds of kilobytes a pipeline and looks as if it leaked. Submit nothing, once.
# Seen:
#   held after 2,000: over 20 MiB; after an empty submission: under 2 MiB
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download mesa-vulkan-drivers=22.3.6-1+deb12u2 libllvm15=1:15.0.6-4+b1 \
    libvulkan1=1.3.239.0-1 libvulkan-dev=1.3.239.0-1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >pipelines.c <<'CODE'
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <vulkan/vulkan.h>
// A compute shader that does nothing.
static const uint32_t code[] = {0x07230203, 0x10000, 0, 5, 0, 2 << 16 | 17, 1, 3 << 16 | 14, 0, 1,
                                5 << 16 | 15, 5, 3, 0x6E69616D, 0, 6 << 16 | 16, 3, 17, 1, 1, 1,
                                2 << 16 | 19, 1, 3 << 16 | 33, 2, 1, 5 << 16 | 54, 1, 3, 0, 2, 2 << 16 | 248, 4,
                                1 << 16 | 253, 1 << 16 | 56};
static void must(VkResult result) {
    if (result != VK_SUCCESS) exit(2);
}
static const char* held(size_t before) {
    const struct mallinfo2 heap = mallinfo2();
    const size_t now = heap.uordblks + heap.hblkhd;
    const size_t mib = 1024 * 1024;
    fprintf(stderr, "%.1f MiB\n", ((double)now - (double)before) / (double)mib);
    return now > before + 20 * mib ? "over 20 MiB" : now < before + 2 * mib ? "under 2 MiB" : "between";
}
int main(void) {
    VkInstance instance;
    must(vkCreateInstance(&(VkInstanceCreateInfo){.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO}, NULL, &instance));
    uint32_t count = 1;
    VkPhysicalDevice physical;
    must(vkEnumeratePhysicalDevices(instance, &count, &physical));
    const float priority = 1.0F;
    const VkDeviceQueueCreateInfo queues = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    VkDevice device;
    must(vkCreateDevice(physical,
                        &(VkDeviceCreateInfo){.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                              .queueCreateInfoCount = 1,
                                              .pQueueCreateInfos = &queues},
                        NULL, &device));
    VkPipelineLayout layout;
    must(vkCreatePipelineLayout(
        device, &(VkPipelineLayoutCreateInfo){.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO}, NULL, &layout));
    VkShaderModule module;
    must(vkCreateShaderModule(device,
                              &(VkShaderModuleCreateInfo){.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                                          .codeSize = sizeof code,
                                                          .pCode = code},
                              NULL, &module));
    const VkComputePipelineCreateInfo wish = {
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = module,
                  .pName = "main"},
        .layout = layout};
    size_t before = 0;
    for (int i = 0; i < 2000; ++i) {
        VkPipeline pipeline;
        must(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &wish, NULL, &pipeline));
        vkDestroyPipeline(device, pipeline, NULL);
        if (i == 0) {
            const struct mallinfo2 heap = mallinfo2();
            before = heap.uordblks + heap.hblkhd;
        }
    }
    printf("held after 2,000: %s; ", held(before));
    VkQueue queue;
    vkGetDeviceQueue(device, 0, 0, &queue);
    must(vkQueueSubmit(queue, 1, &(VkSubmitInfo){.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO}, VK_NULL_HANDLE));
    must(vkQueueWaitIdle(queue));
    printf("after an empty submission: %s", held(before));
    return 0;
}
CODE
gcc -O1 -Iusr/include pipelines.c -o pipelines "$libraries/libvulkan.so.1"
cat >lavapipe.json <<ICD
{"file_format_version": "1.0.0", "ICD": {"library_path": "$libraries/libvulkan_lvp.so", "api_version": "1.3.230"}}
ICD
saw=$(MESA_SHADER_CACHE_DISABLE=true VK_ICD_FILENAMES="$PWD/lavapipe.json" LD_LIBRARY_PATH="$libraries" ./pipelines)
echo "saw: $saw"
[ "$saw" = "held after 2,000: over 20 MiB; after an empty submission: under 2 MiB" ]
