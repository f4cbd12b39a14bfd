// The only door to the Vulkan headers.
#pragma once

#include <vulkan/vulkan.h>
