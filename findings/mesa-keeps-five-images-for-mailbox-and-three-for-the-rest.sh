#!/usr/bin/env bash
# Package: mesa-vulkan-drivers 22.3.6-1+deb12u2, libvulkan1, libvulkan-dev 1.3.239.0-1 (Debian 12), the software driver in Xvfb.
# Behaviour: a surface says that a swapchain has at least three images. One that is asked for three has three for FIFO and
# for immediate, and five for mailbox.
# Expected: three for each, as asked, as the driver's own least number says for the surface, whatever the mode.
# Why it matters: a picture of 3840x2160 is 33 MB, so the mode alone takes 66 MB more; what a program keeps an image (command
# buffers, semaphores) by the number that it asked for is too short. Ask how many came.
# Seen:
#   least 3; asked for 3: fifo 3, immediate 3, mailbox 5
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download mesa-vulkan-drivers=22.3.6-1+deb12u2 libllvm15=1:15.0.6-4+b1 \
    libvulkan1=1.3.239.0-1 libvulkan-dev=1.3.239.0-1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >images.c <<'CODE'
#define VK_USE_PLATFORM_XLIB_KHR
#include <X11/Xlib.h>
#include <stdio.h>
#include <stdlib.h>
#include <vulkan/vulkan.h>
static void need(VkResult result, int line) {
    if (result != VK_SUCCESS) { fprintf(stderr, "line %d: VkResult %d\n", line, result); exit(2); }
}
#define NEED(call) need(call, __LINE__)
int main(void) {
    Display* display = XOpenDisplay(NULL);
    if (display == NULL) return 2;
    Window window = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 320, 200, 0, 0, 0);
    XMapWindow(display, window);
    XSync(display, False);
    const char* const of_instance[] = {"VK_KHR_surface", "VK_KHR_xlib_surface"};
    VkInstance instance;
    NEED(vkCreateInstance(&(VkInstanceCreateInfo){.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                                  .enabledExtensionCount = 2,
                                                  .ppEnabledExtensionNames = of_instance},
                          NULL, &instance));
    VkPhysicalDevice card;
    uint32_t cards = 1;
    if (vkEnumeratePhysicalDevices(instance, &cards, &card) < 0 || cards != 1) return 2;
    VkSurfaceKHR surface;
    NEED(vkCreateXlibSurfaceKHR(instance,
                                &(VkXlibSurfaceCreateInfoKHR){.sType = VK_STRUCTURE_TYPE_XLIB_SURFACE_CREATE_INFO_KHR,
                                                              .dpy = display,
                                                              .window = window},
                                NULL, &surface));
    const float priority = 1;
    const VkDeviceQueueCreateInfo queue = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    const char* const of_device = "VK_KHR_swapchain";
    VkDevice device;
    NEED(vkCreateDevice(card,
                        &(VkDeviceCreateInfo){.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                              .queueCreateInfoCount = 1,
                                              .pQueueCreateInfos = &queue,
                                              .enabledExtensionCount = 1,
                                              .ppEnabledExtensionNames = &of_device},
                        NULL, &device));
    VkSurfaceCapabilitiesKHR can;
    NEED(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(card, surface, &can));
    printf("least %u; asked for %u:", can.minImageCount, can.minImageCount);
    static const struct {
        VkPresentModeKHR mode;
        const char* name;
    } modes[] = {{VK_PRESENT_MODE_FIFO_KHR, " fifo"},
                 {VK_PRESENT_MODE_IMMEDIATE_KHR, ", immediate"},
                 {VK_PRESENT_MODE_MAILBOX_KHR, ", mailbox"}};
    for (int at = 0; at < 3; ++at) {
        VkSwapchainKHR chain;
        NEED(vkCreateSwapchainKHR(device,
                                  &(VkSwapchainCreateInfoKHR){.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
                                                              .surface = surface,
                                                              .minImageCount = can.minImageCount,
                                                              .imageFormat = VK_FORMAT_B8G8R8A8_UNORM,
                                                              .imageExtent = can.currentExtent,
                                                              .imageArrayLayers = 1,
                                                              .imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                                              .preTransform = can.currentTransform,
                                                              .compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR,
                                                              .presentMode = modes[at].mode},
                                  NULL, &chain));
        uint32_t images = 0;
        NEED(vkGetSwapchainImagesKHR(device, chain, &images, NULL));
        printf("%s %u", modes[at].name, images);
        vkDestroySwapchainKHR(device, chain, NULL);
    }
    return 0;
}
CODE
gcc -Iusr/include images.c -o images "$libraries/libvulkan.so.1" -lX11 -Wl,--unresolved-symbols=ignore-in-shared-libs
sed "s#\"library_path\": \".*\"#\"library_path\": \"$libraries/libvulkan_lvp.so\"#" usr/share/vulkan/icd.d/lvp_icd.x86_64.json >driver.json
saw=$(LD_LIBRARY_PATH=$libraries VK_ICD_FILENAMES=$PWD/driver.json VK_DRIVER_FILES=$PWD/driver.json xvfb-run -a ./images)
echo "saw: $saw"
[ "$saw" = "least 3; asked for 3: fifo 3, immediate 3, mailbox 5" ]
