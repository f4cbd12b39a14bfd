// What the server sends: each answer with its head. Inside this room. Any one thread.
#pragma once

#include <microhttpd.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "game/app/sharing/page_store.h"
#include "game/sharing/page_files.h"
#include "game/sharing/share_request.h"

namespace onggi::app {

// An answer that is ready to be sent, once or often.
class Response {
  public:
    Response() = default;
    Response(MHD_Response* response, unsigned status, std::uint64_t bytes)
        : response_(response, &MHD_destroy_response),
          status_(status),
          bytes_(bytes) {}

    explicit operator bool() const { return response_ != nullptr; }
    [[nodiscard]] MHD_Response* get() const { return response_.get(); }
    [[nodiscard]] unsigned status() const { return status_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    void add(const char* name, const std::string& value) const {
        MHD_add_response_header(response_.get(), name, value.c_str());
    }

  private:
    std::shared_ptr<MHD_Response> response_;
    unsigned status_ = 0;
    std::uint64_t bytes_ = 0;
};

class Responses {
  public:
    Responses();

    // All of the file, or the bytes that `range` means; `is_twin`: it is the packed one.
    [[nodiscard]] static Response of_file(OpenFile file, const sharing::PageFile& known,
                                          std::string_view range, bool is_twin);
    // What is no file of a pot: held ready.
    [[nodiscard]] Response without_a_file(const sharing::ShareAnswer& answer,
                                          std::string_view accept_language) const;
    [[nodiscard]] Response lost(std::string_view accept_language) const;
    [[nodiscard]] Response too_many() const { return too_many_; }

  private:
    // By language, in the order of kiosk::built_in_languages().
    std::vector<Response> lost_;
    std::vector<Response> ask_;
    Response script_;
    Response robots_;
    Response nothing_;
    Response not_allowed_;
    Response bad_request_;
    Response too_many_;
};

}  // namespace onggi::app
