// The socket to the Inverse service: a WebSocket client (libwebsockets) as the work of one I/O thread. It
// tries every two seconds to connect, and says and takes what the session wants.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/haptics/haply/inverse_session.h"
#include "engine/jobs/io_thread.h"

namespace onggi::haptics::haply {

class InverseClient final : public jobs::IoWork {
  public:
    InverseClient(InverseLink& link, const InverseOptions& options);
    ~InverseClient() override;

    [[nodiscard]] std::int64_t round(std::int64_t now_ns) noexcept override;
    void finish() noexcept override;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace onggi::haptics::haply
