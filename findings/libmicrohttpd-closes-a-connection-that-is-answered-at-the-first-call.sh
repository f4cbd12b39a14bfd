#!/usr/bin/env bash
# Package: libmicrohttpd12, libmicrohttpd-dev 0.9.75-6 (Debian 12).
# Behaviour: the library calls a request's handler first with the head alone. A handler that answers a GET there is
# obeyed, and the connection is closed after the answer, with "Connection: close". One that waits for the second call,
# which for a GET brings nothing new, keeps the connection.
# Expected: the same: a GET without a body is complete with its head, and HTTP/1.1 keeps the connection.
# Why it matters: a page of twenty pictures costs twenty connections from each phone, and a limit of connections an address
# turns visitors away. Answer at the second call; nothing but the header shows the difference.
# Seen:
#   answered at call 1: 1 of 3 requests on a connection, closed; at call 2: 3 of 3
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download libmicrohttpd12=0.9.75-6 libmicrohttpd-dev=0.9.75-6
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >serve.c <<'CODE'
#include <arpa/inet.h>
#include <microhttpd.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>
static int answer_at;  // which call of the handler
static enum MHD_Result handle(void* all, struct MHD_Connection* connection, const char* target, const char* method,
                              const char* version, const char* data, size_t* size, void** request) {
    static int seen;
    (void)all, (void)target, (void)method, (void)version, (void)data, (void)size;
    if (*request == NULL && answer_at == 2) {
        *request = &seen;
        return MHD_YES;
    }
    struct MHD_Response* response = MHD_create_response_from_buffer(3, (void*)"pot", MHD_RESPMEM_PERSISTENT);
    const enum MHD_Result queued = MHD_queue_response(connection, 200, response);
    MHD_destroy_response(response);
    return queued;
}
// Answers that three requests get on one connection.
static int answers(int port) {
    const int client = socket(AF_INET, SOCK_STREAM, 0);
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons(port), .sin_addr.s_addr = htonl(INADDR_LOOPBACK)};
    if (connect(client, (struct sockaddr*)&address, sizeof address) != 0) return -1;
    const char request[] = "GET / HTTP/1.1\r\nHost: kiosk\r\n\r\n";
    int got = 0;
    for (; got < 3; ++got) {
        char answer[1000] = "";
        size_t length = 0;
        if (send(client, request, sizeof request - 1, MSG_NOSIGNAL) < 0) break;
        while (strstr(answer, "\r\n\r\npot") == NULL) {
            const ssize_t more = recv(client, answer + length, sizeof answer - 1 - length, 0);
            if (more <= 0) break;
            length += more;
        }
        if (length == 0) break;
    }
    close(client);
    return got;
}
int main(void) {
    int got[2];
    for (answer_at = 1; answer_at <= 2; ++answer_at) {
        struct MHD_Daemon* daemon =
            MHD_start_daemon(MHD_USE_INTERNAL_POLLING_THREAD, 0, NULL, NULL, handle, NULL, MHD_OPTION_END);
        if (daemon == NULL) return 2;
        got[answer_at - 1] = answers(MHD_get_daemon_info(daemon, MHD_DAEMON_INFO_BIND_PORT)->port);
        MHD_stop_daemon(daemon);
    }
    printf("answered at call 1: %d of 3 requests on a connection%s; at call 2: %d of 3", got[0], got[0] < 3 ? ", closed" : "",
           got[1]);
    return 0;
}
CODE
gcc -Iusr/include serve.c -o serve "$libraries/libmicrohttpd.so.12" -Wl,--unresolved-symbols=ignore-in-shared-libs
saw=$(LD_LIBRARY_PATH=$libraries ./serve)
echo "saw: $saw"
[ "$saw" = "answered at call 1: 1 of 3 requests on a connection, closed; at call 2: 3 of 3" ]
