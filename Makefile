# make demo    sets everything up, then tracks the bundled recording through a real service
# make test    sets everything up, then runs all that CI runs

VENV := .venv
BIN := $(VENV)/bin

# cpu, openvino or gpu: the build of onnxruntime that is installed. They overwrite each other, so it is one of them: what
# is there already, else openvino where the CPU multiplies in bfloat16. All three have the plain CPU provider as well.
FASTEST = $(if $(shell grep -E -m1 -o '\b(avx512_bf16|amx_bf16)\b' /proc/cpuinfo 2>/dev/null),openvino,cpu)
RUNTIME ?= $(or $(patsubst $(VENV)/installed-%,%,$(firstword $(wildcard $(VENV)/installed-*))),$(FASTEST))
PYTHON ?= $(shell command -v python3.11 || command -v python3)
TORCH ?= torch==2.13.0

STAMP := $(VENV)/installed-$(RUNTIME)

.PHONY: venv demo serve test browser lint image bench clean

venv: $(STAMP)

$(STAMP): pyproject.toml
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "Python 3.11 or newer is needed: make PYTHON=/path/to/python3.11")'
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	rm -f $(VENV)/installed-*
	$(BIN)/python -m pip uninstall --quiet --yes onnxruntime onnxruntime-openvino onnxruntime-gpu
	$(BIN)/python -m pip install $(TORCH)
	$(BIN)/python -m pip install --editable '.[$(RUNTIME),train,export,dev]'
	touch $@

demo: venv
	$(BIN)/captra demo $(ARGS)

serve: venv
	$(BIN)/captra serve $(ARGS)

test: lint browser
	$(BIN)/python -m pytest $(ARGS)

# A browser that the live page is tested in, where none is: the distribution's (as root), otherwise Playwright's own.
browser: venv
	$(BIN)/python -m benchmarks.browser

lint: venv
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

# The image without a container engine: every step of the Dockerfile in a folder, then a recording tracked by it. Root.
# RUNTIME is that of the image; the environment that plays it through stays as it is.
image: $(or $(firstword $(wildcard $(VENV)/installed-*)),$(STAMP))
	$(BIN)/python -m docker.rehearse --runtime $(RUNTIME) $(ARGS)

# A few minutes; ARGS="--provider cpu --provider openvino" compares both.
bench: venv
	mkdir -p .bench
	$(BIN)/captra bench --recording recordings/mug__sweethome3d-KatorLegaz__coffee-mug__hand.npz \
		--recording recordings/drawers__sweethome3d-BlendSwap-CC-0__drawersCabinet__hand.npz \
		--streams 1 --streams 4 --frames 60 --scaling --hop --json .bench/bench.json $(ARGS)
	$(BIN)/python -m benchmarks.steps

clean:
	rm -rf $(VENV) .bench build *.egg-info .mypy_cache .pytest_cache .ruff_cache .hypothesis
