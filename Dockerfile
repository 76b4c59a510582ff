# docker build -t thermocontact .
# docker run --rm -v "$PWD":/work thermocontact FILE.prm
#
# Runs on any x86-64: of three programs the container takes the one with the widest
# instructions, AVX-512, AVX2 or neither, that the processor has.
FROM debian:13
COPY . /thermocontact
WORKDIR /thermocontact
RUN scripts/install_packages python3-matplotlib && \
    for bytes in 16 32 64; do \
      cmake -S . -B build/$bytes -DCMAKE_BUILD_TYPE=Release -DTHERMOCONTACT_LANE_BYTES=$bytes && \
      cmake --build build/$bytes --target thermocontact -j"$(nproc)" || exit 1; \
    done && \
    rm -rf build/*/CMakeFiles build/*/*.a
WORKDIR /work
ENTRYPOINT ["/bin/sh", "-c", "bytes=16; grep -qw avx2 /proc/cpuinfo && bytes=32; grep -qw avx512vl /proc/cpuinfo && bytes=64; exec /thermocontact/build/$bytes/thermocontact \"$@\"", "thermocontact"]
