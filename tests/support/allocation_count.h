// How often this test program has allocated. Linking onggi_allocation_count replaces operator new for the
// whole program. Any thread.
#pragma once

namespace onggi::test {

[[nodiscard]] int allocation_count();

}  // namespace onggi::test
