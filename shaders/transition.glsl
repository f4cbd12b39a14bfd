// What a glide needs just now. The whole screen goes through it while the camera moves, and one core does not
// skip what an `if` leaves out: each need is a pipeline of its own.
layout(constant_id = 0) const bool kMixes = false;  // the second background shows
layout(constant_id = 1) const bool kDims = false;   // it is not full day
