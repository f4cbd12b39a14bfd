#!/usr/bin/env bash
# Package: mesa-vulkan-drivers 22.3.6-1+deb12u2 (Debian 12), software Vulkan (lavapipe).
# Behaviour: of a program that keeps itself to one core before it opens Vulkan, the driver's threads keep to that core, as they
# inherit it, but for the one that writes the cache of shaders to the disk: it gives itself all cores of the machine.
# Expected: a thread runs where its maker may; a program that leaves a core free has done so for its libraries.
# Why it matters: the core that is kept for a haptic loop at 1 kHz is no longer its own as soon as a shader is compiled. Set the
# cores of every thread once the device is open, or switch the cache off (MESA_SHADER_CACHE_DISABLE).
# Seen:
#   with the cache: disk on all cores, others on one; without it: others on one
set -euo pipefail
[ "$(nproc)" -gt 1 ] || { echo "needs two cores"; exit 1; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download mesa-vulkan-drivers=22.3.6-1+deb12u2 libllvm15=1:15.0.6-4+b1 \
    libvulkan1=1.3.239.0-1 libvulkan-dev=1.3.239.0-1
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >cores.c <<'CODE'
// Opens a device on one core; prints each thread's name and the cores that it may use.
#define _GNU_SOURCE
#include <dirent.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include <vulkan/vulkan.h>
static void must(VkResult result) {
    if (result != VK_SUCCESS) exit(2);
}
int main(void) {
    cpu_set_t cores;
    if (sched_getaffinity(0, sizeof cores, &cores) != 0) return 2;
    int first = 0;
    while (!CPU_ISSET(first, &cores)) ++first;
    CPU_ZERO(&cores);
    CPU_SET(first, &cores);
    if (sched_setaffinity(0, sizeof cores, &cores) != 0) return 2;
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
    sleep(1);  // each thread names and places itself
    DIR* tasks = opendir("/proc/self/task");
    for (struct dirent* task; (task = readdir(tasks)) != NULL;) {
        if (task->d_name[0] == '.' || sched_getaffinity(atoi(task->d_name), sizeof cores, &cores) != 0) continue;
        char path[300], name[32] = "";
        snprintf(path, sizeof path, "/proc/self/task/%s/comm", task->d_name);
        FILE* file = fopen(path, "r");
        if (file == NULL || fgets(name, sizeof name, file) == NULL) return 2;
        fclose(file);
        printf("%d %s", CPU_COUNT(&cores), name);
    }
    return 0;
}
CODE
gcc -O1 -Iusr/include cores.c -o cores "$libraries/libvulkan.so.1"
cat >lavapipe.json <<ICD
{"file_format_version": "1.0.0", "ICD": {"library_path": "$libraries/libvulkan_lvp.so", "api_version": "1.3.230"}}
ICD
# threads DISABLED: which threads may use which cores.
threads() {
    MESA_SHADER_CACHE_DISABLE=$1 MESA_SHADER_CACHE_DIR=$PWD/cache VK_ICD_FILENAMES=$PWD/lavapipe.json LD_LIBRARY_PATH=$libraries \
        ./cores | awk -v all="$(nproc)" '{
            name = $2 ~ /:disk/ ? "disk" : "others"
            where = $1 == all ? "all cores" : $1 == 1 ? "one" : "some"
            if (!(name in seen)) seen[name] = where; else if (seen[name] != where) seen[name] = "several"
        } END { said = "disk" in seen ? "disk on " seen["disk"] ", " : ""; print said "others on " seen["others"] }'
}
saw="with the cache: $(threads false); without it: $(threads true)"
echo "saw: $saw"
[ "$saw" = "with the cache: disk on all cores, others on one; without it: others on one" ]
