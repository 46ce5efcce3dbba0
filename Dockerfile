# An image with the program alone: docker build -t slipmode . && docker run --rm -v "$PWD:/work" slipmode verify REPORT
FROM rust:1.95-slim-bookworm AS build
RUN apt-get update && apt-get install --yes --no-install-recommends gcc libc6-dev make m4 diffutils && rm -rf /var/lib/apt/lists/*
WORKDIR /source
COPY . .
RUN cargo install --locked --path . --root /opt/slipmode

FROM debian:bookworm-slim
COPY --from=build /opt/slipmode/bin/slipmode /usr/local/bin/slipmode
WORKDIR /work
ENTRYPOINT ["slipmode"]
