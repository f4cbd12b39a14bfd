// The one descriptor set, for the shaders that include it.
#include "frame_data.h"

layout(std140, set = 0, binding = kBindFrame) uniform FrameBlock {
    FrameData frame;
};
