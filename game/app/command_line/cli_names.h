// The names of CLI11 that headers speak of. The whole header takes g++ ten seconds, so only the files that
// register options include it.
#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI
