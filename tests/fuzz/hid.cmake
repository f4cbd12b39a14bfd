# What a plugged-in device may say: its descriptor and its reports.
onggi_fuzz_target(hid_descriptor MAX_BYTES 4096 LINKS onggi_hid_protocol)
onggi_fuzz_target(hid_reports MAX_BYTES 1024 LINKS onggi_hid_protocol)
target_sources(fuzz_hid_reports PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/pid_descriptors.cpp)
# And what a haptic service on the same machine may say.
onggi_fuzz_target(haply MAX_BYTES 4096 LINKS onggi_haply_protocol)
