# docker build -t thermocontact .
# docker run --rm -v "$PWD/results:/thermocontact/results" thermocontact FILE.prm
FROM debian:12
COPY . /thermocontact
WORKDIR /thermocontact
RUN scripts/install_packages python3-matplotlib && scripts/build Release
ENTRYPOINT ["/thermocontact/scripts/run"]
