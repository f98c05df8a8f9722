# captra as a service: docker build --build-arg RUNTIME=openvino --tag captra:openvino .
# RUNTIME is cpu (runs everywhere), openvino (faster on x86) or gpu (CUDA). `make image` plays this file through without
# Docker.
ARG RUNTIME=cpu

FROM debian:bookworm-slim AS python
COPY docker/python.sh /docker/
RUN /docker/python.sh

FROM python AS build
ARG RUNTIME
COPY docker/installer.sh /docker/
RUN /docker/installer.sh
COPY pyproject.toml README.md /source/
COPY captra /source/captra
COPY clients /source/clients
COPY export /source/export
COPY service /source/service
COPY docker /source/docker
RUN /source/docker/packages.sh /source "$RUNTIME" /opt/captra
COPY models /source/models
RUN /source/docker/kernels.sh /opt/captra /source/models

FROM python
COPY docker/user.sh /docker/
RUN /docker/user.sh /var/lib/captra
COPY --from=build /opt/captra /opt/captra
COPY models /opt/captra/models
ENV PATH=/opt/captra/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    PYTHONDONTWRITEBYTECODE=1 \
    PYTHONUNBUFFERED=1 \
    ORT_DISABLE_TELEMETRY=1 \
    CAPTRA_MODELS_DIR=/opt/captra/models \
    CAPTRA_STATE_DIR=/var/lib/captra \
    CAPTRA_HTTP_HOST=0.0.0.0 \
    CAPTRA_ZENOH_LISTEN='["tcp/0.0.0.0:7447"]'
USER 10001:10001
VOLUME /var/lib/captra
EXPOSE 8080 7447
HEALTHCHECK --interval=30s --timeout=10s --start-period=60s CMD ["captra", "status", "--quiet"]
ENTRYPOINT ["start.sh"]
CMD ["serve"]
