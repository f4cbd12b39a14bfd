#!/usr/bin/env bash
# Package: mesa-vulkan-drivers 22.3.6-1+deb12u2 (Debian 12), software Vulkan (lavapipe), on an X server that has MIT-SHM and
# Present but no DRI3, as without a GPU (here Xvfb).
# Behaviour: vkQueuePresentKHR writes every pixel of every image into the socket to the X server, although the driver is linked
# with libxcb-shm and the server on the same machine offers to share memory: 20 images of 640x480 are 24.6 MB.
# Expected: a few kilobytes, as OpenGL of the same package and every toolkit do it: the server reads shared memory.
# Why it matters: a kiosk without a GPU at 4K and 60 Hz sends 2 GB a second to a program beside it, in pieces of 219 kB; at
# 720p and 30 Hz it wakes 500 times a second for them. An image bound to shared memory (VK_EXT_external_memory_host) and
# xcb_shm_put_image send nothing.
# Seen:
#   MIT-SHM yes, DRI3 no; written for 20 images: all their pixels
set -euo pipefail
folder=$(mktemp -d)
server=
trap 'kill $server 2>/dev/null || true; rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download mesa-vulkan-drivers=22.3.6-1+deb12u2 libllvm15=1:15.0.6-4+b1 \
    libvulkan1=1.3.239.0-1 libvulkan-dev=1.3.239.0-1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >present.c <<'CODE'
#define VK_USE_PLATFORM_XCB_KHR
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>
enum { kWidth = 640, kHeight = 480, kImages = 20 };
static void must(VkResult result) {
    if (result != VK_SUCCESS) exit(2);
}
// What this process has written to files and sockets.
static long long written(void) {
    FILE* account = fopen("/proc/self/io", "r");
    char line[100];
    long long bytes = -1;
    while (account && fgets(line, sizeof line, account)) sscanf(line, "wchar: %lld", &bytes);
    fclose(account);
    return bytes;
}
static const char* has(xcb_connection_t* server, const char* name) {
    xcb_query_extension_reply_t* reply =
        xcb_query_extension_reply(server, xcb_query_extension(server, (uint16_t)strlen(name), name), NULL);
    return reply && reply->present ? "yes" : "no";
}
int main(void) {
    xcb_connection_t* server = xcb_connect(NULL, NULL);
    xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(server)).data;
    const xcb_window_t window = xcb_generate_id(server);
    xcb_create_window(server, XCB_COPY_FROM_PARENT, window, screen->root, 0, 0, kWidth, kHeight, 0,
                      XCB_WINDOW_CLASS_INPUT_OUTPUT, screen->root_visual, 0, NULL);
    xcb_map_window(server, window);
    xcb_flush(server);
    const char* const needs[] = {"VK_KHR_surface", "VK_KHR_xcb_surface"};
    VkInstance instance;
    must(vkCreateInstance(&(VkInstanceCreateInfo){.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                                  .enabledExtensionCount = 2,
                                                  .ppEnabledExtensionNames = needs},
                          NULL, &instance));
    uint32_t count = 1;
    VkPhysicalDevice physical;
    must(vkEnumeratePhysicalDevices(instance, &count, &physical));
    VkSurfaceKHR surface;
    must(vkCreateXcbSurfaceKHR(instance,
                               &(VkXcbSurfaceCreateInfoKHR){.sType = VK_STRUCTURE_TYPE_XCB_SURFACE_CREATE_INFO_KHR,
                                                            .connection = server,
                                                            .window = window},
                               NULL, &surface));
    VkBool32 presents = VK_FALSE;
    must(vkGetPhysicalDeviceSurfaceSupportKHR(physical, 0, surface, &presents));
    if (!presents) return 3;
    const char* const swaps[] = {"VK_KHR_swapchain"};
    const float priority = 1.0F;
    const VkDeviceQueueCreateInfo queues = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    VkDevice device;
    must(vkCreateDevice(physical,
                        &(VkDeviceCreateInfo){.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                              .queueCreateInfoCount = 1,
                                              .pQueueCreateInfos = &queues,
                                              .enabledExtensionCount = 1,
                                              .ppEnabledExtensionNames = swaps},
                        NULL, &device));
    VkSwapchainKHR chain;
    must(vkCreateSwapchainKHR(device,
                              &(VkSwapchainCreateInfoKHR){.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
                                                          .surface = surface,
                                                          .minImageCount = 4,
                                                          .imageFormat = VK_FORMAT_B8G8R8A8_UNORM,
                                                          .imageExtent = {kWidth, kHeight},
                                                          .imageArrayLayers = 1,
                                                          .imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                                                          .preTransform = VK_SURFACE_TRANSFORM_IDENTITY_BIT_KHR,
                                                          .compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR,
                                                          .presentMode = VK_PRESENT_MODE_FIFO_KHR},
                              NULL, &chain));
    VkImage images[16];
    count = 16;
    must(vkGetSwapchainImagesKHR(device, chain, &count, images));
    VkQueue queue;
    vkGetDeviceQueue(device, 0, 0, &queue);
    VkCommandPool pool;
    must(vkCreateCommandPool(device, &(VkCommandPoolCreateInfo){.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO}, NULL,
                             &pool));
    VkFence fence;
    must(vkCreateFence(device, &(VkFenceCreateInfo){.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO}, NULL, &fence));
    const long long before = written();
    for (int frame = 0; frame < kImages; ++frame) {
        uint32_t image;
        must(vkAcquireNextImageKHR(device, chain, UINT64_MAX, VK_NULL_HANDLE, fence, &image));
        must(vkWaitForFences(device, 1, &fence, VK_TRUE, UINT64_MAX));
        must(vkResetFences(device, 1, &fence));
        VkCommandBuffer commands;
        must(vkAllocateCommandBuffers(device,
                                      &(VkCommandBufferAllocateInfo){.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                                     .commandPool = pool,
                                                                     .commandBufferCount = 1},
                                      &commands));
        must(vkBeginCommandBuffer(commands,
                                  &(VkCommandBufferBeginInfo){.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO}));
        const VkImageMemoryBarrier shown = {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                                            .newLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
                                            .image = images[image],
                                            .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
        vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, 0, 0, NULL, 0,
                             NULL, 1, &shown);
        must(vkEndCommandBuffer(commands));
        must(vkQueueSubmit(queue, 1,
                           &(VkSubmitInfo){.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands},
                           VK_NULL_HANDLE));
        must(vkQueueWaitIdle(queue));
        must(vkQueuePresentKHR(queue, &(VkPresentInfoKHR){.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR,
                                                          .swapchainCount = 1,
                                                          .pSwapchains = &chain,
                                                          .pImageIndices = &image}));
    }
    vkDeviceWaitIdle(device);
    const long long bytes = written() - before;
    const long long pixels = 4LL * kWidth * kHeight * kImages;
    fprintf(stderr, "%lld bytes written, %lld of pixels\n", bytes, pixels);
    printf("MIT-SHM %s, DRI3 %s; written for %d images: %s", has(server, "MIT-SHM"), has(server, "DRI3"), kImages,
           bytes >= pixels * 9 / 10 ? "all their pixels" : bytes < pixels / 100 ? "under a hundredth" : "a part");
    return 0;
}
CODE
gcc -O1 -Iusr/include present.c -o present "$libraries/libvulkan.so.1" -lxcb
cat >lavapipe.json <<ICD
{"file_format_version": "1.0.0", "ICD": {"library_path": "$libraries/libvulkan_lvp.so", "api_version": "1.3.230"}}
ICD
Xvfb -screen 0 1280x720x24 -nolisten tcp -noreset -displayfd 1 >display 2>/dev/null &
server=$!
until [ -s display ]; do
    kill -0 "$server"
    sleep 0.1
done
saw=$(DISPLAY=:$(cat display) VK_ICD_FILENAMES="$PWD/lavapipe.json" LD_LIBRARY_PATH="$libraries" ./present)
echo "saw: $saw"
[ "$saw" = "MIT-SHM yes, DRI3 no; written for 20 images: all their pixels" ]
