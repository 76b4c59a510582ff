# docker build -t thermocontact .
# docker run --rm -v "$PWD":/work thermocontact FILE.prm
#
# Runs on any x86-64: of two programs the container takes the one with AVX2 and FMA
# instructions where the processor has them.
FROM debian:13
COPY . /thermocontact
WORKDIR /thermocontact
RUN scripts/install_packages python3-matplotlib && \
    for avx2 in OFF ON; do \
      cmake -S . -B build/avx2-$avx2 -DCMAKE_BUILD_TYPE=Release -DTHERMOCONTACT_AVX2=$avx2 && \
      cmake --build build/avx2-$avx2 --target thermocontact -j"$(nproc)" || exit 1; \
    done && \
    rm -rf build/avx2-*/CMakeFiles build/avx2-*/*.a
WORKDIR /work
ENTRYPOINT ["/bin/sh", "-c", "case $(grep -m 1 ^flags /proc/cpuinfo) in *\" avx2 \"*) avx2=ON ;; *) avx2=OFF ;; esac; exec /thermocontact/build/avx2-$avx2/thermocontact \"$@\"", "thermocontact"]
