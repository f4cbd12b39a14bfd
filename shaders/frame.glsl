// The one descriptor set, for whoever includes it.
#include "frame_data.h"

layout(std140, set = 0, binding = kBindFrame) uniform FrameBlock {
    FrameData frame;
};
