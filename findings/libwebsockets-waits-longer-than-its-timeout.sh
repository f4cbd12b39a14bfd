#!/usr/bin/env bash
# Package: libwebsockets17, libwebsockets-dev 4.1.6-3 (Debian 12).
# Behaviour: lws_service(context, 10) does not return after 10 ms. With nothing to do it waits until an event, a timer of the
# library or another thread's lws_cancel_service(): here for the whole second that passes until then. A timer of 10 ms,
# scheduled before the call, ends it in time.
# Expected: what the second argument, a time-out in milliseconds, says; it is accepted in silence.
# Why it matters: a haptic or kiosk loop that talks to a device's service by a WebSocket and counts on its rounds being
# short stands still as soon as the service is silent, and no force is taken back.
# Seen:
#   time-out of 10 ms: over 0.9 s; timer of 10 ms: under 0.5 s
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download libwebsockets17=4.1.6-3 libwebsockets-dev=4.1.6-3
for package in *.deb; do dpkg-deb -x "$package" .; done
libraries=$PWD/usr/lib/x86_64-linux-gnu
cat >rounds.c <<'CODE'
#include <libwebsockets.h>
#include <pthread.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>
enum { kTimeoutMs = 10, kWakeUs = 1000000 };
static struct lws_context* context;
static int ignored(struct lws* socket, enum lws_callback_reasons reason, void* user, void* in, size_t bytes) {
    (void)socket, (void)reason, (void)user, (void)in, (void)bytes;
    return 0;
}
static void* wake(void* unused) {
    (void)unused;
    usleep(kWakeUs);
    lws_cancel_service(context);
    return NULL;
}
static void due(lws_sorted_usec_list_t* timer) { (void)timer; }
static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}
// How long the longest of three rounds takes: the first has the library's own start to do.
static double longest_round(int has_timer) {
    static lws_sorted_usec_list_t timer;
    pthread_t waker;
    pthread_create(&waker, NULL, wake, NULL);
    double longest = 0.0;
    const double began = seconds();
    for (int round = 0; round < 3 && seconds() < began + 1e-6 * kWakeUs; ++round) {
        const double before = seconds();
        if (has_timer) lws_sul_schedule(context, 0, &timer, due, kTimeoutMs * 1000);
        lws_service(context, kTimeoutMs);
        if (seconds() - before > longest) longest = seconds() - before;
    }
    pthread_join(waker, NULL);
    return longest;
}
int main(void) {
    lws_set_log_level(0, NULL);
    static const struct lws_protocols protocols[] = {{.name = "none", .callback = ignored}, {0}};
    context = lws_create_context(
        &(struct lws_context_creation_info){.port = CONTEXT_PORT_NO_LISTEN, .protocols = protocols});
    if (context == NULL) return 2;
    const double alone = longest_round(0);
    const double timed = longest_round(1);
    fprintf(stderr, "%.3f s and %.3f s\n", alone, timed);
    printf("time-out of 10 ms: %s; timer of 10 ms: %s",
           alone > 0.9 ? "over 0.9 s" : "less", timed < 0.5 ? "under 0.5 s" : "more");
    lws_context_destroy(context);
    return 0;
}
CODE
gcc -Iusr/include rounds.c -o rounds "$libraries/libwebsockets.so.17" -lpthread -Wl,--unresolved-symbols=ignore-in-shared-libs
saw=$(LD_LIBRARY_PATH=$libraries ./rounds)
echo "saw: $saw"
[ "$saw" = "time-out of 10 ms: over 0.9 s; timer of 10 ms: under 0.5 s" ]
