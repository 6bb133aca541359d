# Shortcuts for common tasks; CMake does the work. `make help` lists them.

BUILD   := build/release
PRESET  := --preset release
JOBS    := $(shell nproc)
QUIET   := --no-print-directory
# The property tests draw the same random cases every time; `make properties` draws new ones.
export RC_PARAMS ?= seed=1

# Quiet if everything is up to date: the log is only shown when a step fails.
define quietly
	@mkdir -p build && { $(1) > build/log.txt 2>&1 || { cat build/log.txt; exit 1; }; }
endef

# Builds the target $(1); prints nothing if it is up to date.
define compile
	@ninja -C $(BUILD) -n $(1) | grep -q 'no work to do' || cmake --build $(PRESET) --target $(1)
endef

.PHONY: help
help: ## this list
	@grep -hE '^[a-z -]+:.*## ' Makefile | sed -E 's/^([a-z -]+):.*## (.*)/  make \1\t\2/' | expand -t 22

.PHONY: deps
deps: ## install missing packages
	@scripts/install-deps core tests

.PHONY: build
build: ## build the program and its window: build/release/scenefile, scenefile-window
	@scripts/install-deps core
	@$(MAKE) $(QUIET) configure
	$(call compile,scenefile scenefile-window)

# Without the tests until they are requested, because the program needs none of their packages.
.PHONY: configure configure-tests
configure: $(BUILD)/build.ninja
	@:
configure-tests:
	@grep -qs SCENEFILE_TESTS:BOOL=ON $(BUILD)/CMakeCache.txt || $(MAKE) $(QUIET) -B $(BUILD)/build.ninja TESTS=ON

TESTS := $(if $(wildcard $(BUILD)/CMakeCache.txt),,OFF)
$(BUILD)/build.ninja: CMakePresets.json
	$(call quietly,cmake $(PRESET) $(addprefix -DSCENEFILE_TESTS=,$(TESTS)))

.PHONY: demo
demo: ## install what is missing, build, render scenes/showcase.xml to out/showcase.png
	@scripts/install-deps core
	@$(MAKE) $(QUIET) configure
	$(call compile,scenefile)
	@$(MAKE) $(QUIET) out/showcase.png
	@echo "out/showcase.png is the picture. 'make build' adds the window of scenefile view."

out/showcase.png: $(BUILD)/scenefile scenes/showcase.xml $(wildcard scenes/image/* scenes/mesh/*)
	@mkdir -p out
	@$(BUILD)/scenefile render scenes/showcase.xml -o $@

.PHONY: test
test: ## build and run all tests
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,all)
	@ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) --output-junit tests.xml; status=$$?; \
	  scripts/test-summary $(BUILD)/tests.xml && exit $$status

.PHONY: accept-readings
accept-readings: ## write what the readers answer for tests/fixtures/reading as what the tests expect; look at git diff then
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_format_tests)
	@SCENEFILE_ACCEPT_READINGS=1 $(BUILD)/tests/format/scenefile_format_tests --gtest_brief=1 --gtest_filter='*Readings.AreAsExpected*'
	@git -c safe.directory='*' status --short tests/fixtures/reading

.PHONY: properties
properties: ## CASES=10000 SEED=N: run each property test with this many new random cases
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,all)
	@scripts/properties $(BUILD) $(or $(CASES),10000) $(SEED)

.PHONY: schemas
schemas: ## check that the XML schemas are up to date and that every validator agrees with the reader
	@scripts/install-deps core tests schemas
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile scenefile_schema_findings)
	@ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -R '^schema\.($(or $(CHECKS),generated|agrees|every))' \
	  --output-junit schemas.xml; status=$$?; scripts/test-summary $(BUILD)/schemas.xml && exit $$status

.PHONY: bare-machine
bare-machine: ## SUITE=bookworm: demo, test and install on a minimal Debian (needs root)
	@scripts/install-deps bare
	@scripts/bare-machine $(or $(SUITE),bookworm)

.PHONY: conformance
conformance: ## CORPUS=DIR: compare with every picture listed in DIR/references.tsv
	@test -n "$(CORPUS)" || { echo "say where the corpus is: make conformance CORPUS=DIR"; exit 2; }
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_conformance)
	@$(BUILD)/tests/conformance/scenefile_conformance "$(CORPUS)" out/conformance

.PHONY: realtime
realtime: ## REALTIME=DIR: compare with every picture of the assignment Realtime listed in DIR/references.tsv
	@test -n "$(REALTIME)" || { echo "say where the references are: make realtime REALTIME=DIR"; exit 2; }
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_realtime)
	@$(BUILD)/tests/conformance/scenefile_realtime "$(REALTIME)" out/realtime

.PHONY: mistakes-ledger
mistakes-ledger: ## count diff's answers about pictures with planted mistakes, in out/ledger.tsv; PER_MISTAKE=N: N scenes for each mistake, 0: all; CORPUS=DIR: also the course's scenes
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile scenefile_student scenefile_ask_causes)
	@mkdir -p out/mistakes
	@CORPUS="$(CORPUS)" python3 tests/student/ledger.py write out/ledger.tsv --build $(BUILD) --folder out/mistakes --per-mistake $(or $(PER_MISTAKE),1)

.PHONY: path-mistakes
path-mistakes: ## the same for path-traced pictures
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_student_path scenefile_ask_path)
	@python3 tests/student_path/mistakes.py --build $(BUILD)
	@python3 tests/student_path/mistakes.py --build $(BUILD) --clean 60 --seeds 3

.PHONY: realtime-mistakes
realtime-mistakes: ## the same for pictures of the assignment Realtime
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_realtime_mistakes)
	@$(BUILD)/tests/student/scenefile_realtime_mistakes tests/student/scenes
	@$(BUILD)/tests/student/scenefile_realtime_mistakes tests/student/scenes --habits
	@$(BUILD)/tests/student/scenefile_realtime_mistakes tests/student/scenes --strange
	@$(BUILD)/tests/student/scenefile_realtime_mistakes tests/student/scenes --unknown --per-mistake 1

.PHONY: driver
driver: ## CORPUS=DIR: draw every scene of DIR as the course's driver does, and compare with render
	@test -n "$(CORPUS)" || { echo "say where the corpus is: make driver CORPUS=DIR"; exit 2; }
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_app_tests)
	@SCENEFILE_CORPUS="$(CORPUS)" $(BUILD)/tests/app/scenefile_app_tests --gtest_filter='Driver.*'

.PHONY: explained
explained: ## CORPUS=DIR: explain random pixels of every scene, and compare the sums with the pictures
	@test -n "$(CORPUS)" || { echo "say where the scenes are: make explained CORPUS=DIR"; exit 2; }
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_explained)
	@$(BUILD)/tests/conformance/scenefile_explained "$(CORPUS)" $(or $(PIXELS),100)

.PHONY: engines
engines: ## CORPUS=DIR: draw every scene with the ray tracer and with OpenGL, and report how much the pictures differ
	@test -n "$(CORPUS)" || { echo "say where the scenes are: make engines CORPUS=DIR"; exit 2; }
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_engines)
	@$(BUILD)/tests/view/scenefile_engines "$(CORPUS)" out/engines

.PHONY: laws
laws: ## CORPUS=DIR: check that every scene means and looks the same after XML -> JSON -> XML, and other properties
	@test -n "$(CORPUS)" || { echo "say where the scenes are: make laws CORPUS=DIR"; exit 2; }
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_laws)
	@$(BUILD)/tests/laws/scenefile_laws $(CORPUS)

.PHONY: soak
soak: ## CORPUS=DIR: process 2,000 files of DIR in one process; memory and open files must not grow
	@test -n "$(CORPUS)" || { echo "say where the files are: make soak CORPUS=DIR"; exit 2; }
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	$(call compile,scenefile_soak)
	@$(BUILD)/tests/soak/scenefile_soak 2000 $(CORPUS)

.PHONY: asan asan-files tsan
ROOM_TESTS = $(foreach room,$(1),scenefile_$(room)_tests)
asan: ## all tests with AddressSanitizer and UndefinedBehaviorSanitizer
	@scripts/install-deps core tests
	@cmake --preset asan && cmake --build --preset asan
	@ctest --preset asan -j $(JOBS)
asan-files: ## the same for code that reads and writes files, with the fuzz targets' seeds and findings
	@scripts/install-deps core tests
	@cmake --preset asan && cmake --build --preset asan --target \
	  scenefile_replays $(call ROOM_TESTS,base scene format asset io)
	@ctest --preset asan-files -j $(JOBS) --output-junit tests.xml; status=$$?; \
	  scripts/test-summary build/asan/tests.xml && exit $$status
tsan: ## the multithreaded tests with ThreadSanitizer
	@scripts/install-deps core tests
	@cmake --preset tsan && cmake --build --preset tsan --target scenefile-window $(call ROOM_TESTS,trace path golden app viewer)
	@ctest --preset tsan -j $(JOBS)

.PHONY: coverage
coverage: ## lines and error branches of the reader, the checker and the writer that the tests execute
	@scripts/install-deps core tests coverage
	@cmake --preset coverage && cmake --build --preset coverage --target \
	  scenefile_replays $(call ROOM_TESTS,base scene format asset io)
	@find build/coverage -name '*.gcda' -delete
	@ctest --preset coverage -j $(JOBS)
	@scripts/coverage build/coverage

.PHONY: fuzz
fuzz: ## SECONDS=60: run each fuzz target for this long
	@scripts/install-deps core tests fuzz
	@cmake --preset fuzz && cmake --build --preset fuzz --target scenefile_fuzz
	@tests/fuzz/run build/fuzz $(or $(SECONDS),60)

.PHONY: faults
faults: ## make every call of every command fail once; kill 50 renders, damage 200 bands
	@scripts/install-deps core tests
	@$(MAKE) $(QUIET) configure-tests
	@cmake --build $(PRESET) --target scenefile scenefile_fail_call
	@tests/faults/sweep.py $(BUILD)/scenefile $(BUILD)/tests/faults/libscenefile_fail_call.so
	@tests/faults/resume.py $(BUILD)/scenefile scenes/showcase.xml --kills 50 --damages 200

.PHONY: partitions slurm-test
partitions: ## SCENES="...": draw 200 pictures in stores by random workers, kill 50 of them; all must have the bytes of one process
	@$(MAKE) $(QUIET) build
	@tests/many-machines/partitions.py $(BUILD)/scenefile $(or $(SCENES),$(wildcard scenes/*.xml)) --partitions $(or $(PARTITIONS),200) --kills $(or $(KILLS),50)
slurm-test: ## draw on a Slurm cluster of two nodes on this machine, and kill one of them (needs root)
	@scripts/install-deps slurm
	@$(MAKE) $(QUIET) build
	@tests/many-machines/slurm $(BUILD)/scenefile scenes/showcase.xml 12 --size 640x480

.PHONY: web web-serve web-test
web: ## build for WebAssembly: the page, out/page, and the npm package, out/npm/scenefile-VERSION.tgz
	@scripts/install-deps core web
	$(call quietly,bindings/web/build)
	@tail -5 build/log.txt
web-serve: web ## build the page, and show it at http://localhost:8123 (PORT=N)
	@node web/serve.js out/page $(or $(PORT),8123)
web-test: web ## build the page and the package, and test them; CORPUS=DIR: also compare with the native program; FILES="DIR...": also open all scenes below, as damaged ones
	@scripts/install-deps browser browsers
	@test -z "$(CORPUS)$(FILES)" || $(MAKE) $(QUIET) build
	@FILES="$(FILES)" bindings/web/test
	@test -z "$(FILES)" || scripts/same-answers --check $(BUILD)/scenefile "node build/wasm/package/bin/scenefile.js" $(FILES)
	@test -z "$(CORPUS)" || { scripts/same-answers $(BUILD)/scenefile \
	  "node build/wasm/package/bin/scenefile.js" "$(CORPUS)" && scripts/same-answers --check \
	  $(BUILD)/scenefile "node build/wasm/package/bin/scenefile.js" "$(CORPUS)"; }

.PHONY: ci-full
ci-full: ## all checks, including slow ones: .ci/run, clang-tidy, Debian 13, Blender, sanitizers, failing calls, killed renders, parts, Slurm, coverage, fuzzing, a release
	@.ci/full

.PHONY: release-check
release-check: ## what must work before a release: .ci/run, Debian 13, packages, wheel, npm, browsers, documentation, checksums
	@.ci/release

.PHONY: portable
portable: ## build all rooms but the window and the program with clang 14 and libc++, as for WebAssembly
	@scripts/install-deps core portable
	@cmake --preset portable && cmake --build --preset portable

# The folder may belong to another user, as in a container.
SOURCES = $(or $(shell git -c safe.directory='*' ls-files 'src/*.h' 'src/*.cpp' 'app/*.h' 'app/*.cpp' 'tests/*.h' \
  'tests/*.cpp'),$(error git lists no sources; this needs a clone))

.PHONY: format format-check tidy
format: ## format all sources with clang-format
	@scripts/install-deps format
	@clang-format-14 -i $(SOURCES)
format-check: ## fail if "make format" would change a source
	@scripts/install-deps format
	@clang-format-14 --dry-run --Werror $(SOURCES)
# Unity builds read a header once for many sources.
tidy: ## check the sources with clang-tidy; ROOM=format: only of this room
	@scripts/install-deps core tests format
	$(call quietly,cmake --preset tidy)
	@run-clang-tidy-14 -quiet -p build/tidy -j $(JOBS) -extra-arg=-Wno-unused-command-line-argument \
	  $(if $(ROOM),'scenefile_$(ROOM)(_cold|_tests)?\.dir') > build/tidy/log.txt 2>&1 || { cat build/tidy/log.txt; exit 1; }

.PHONY: bench bench-build bench-quality bench-path
BENCH_TARGETS = scenefile $(addprefix scenefile_bench_,load kernels psnr inside replay memory)
bench-build:
	@scripts/install-deps core bench
	@$(MAKE) $(QUIET) configure
	@grep -qs SCENEFILE_BENCH:BOOL=ON $(BUILD)/CMakeCache.txt || cmake $(PRESET) -DSCENEFILE_BENCH=ON > /dev/null
	@cmake --build $(PRESET) --target $(BENCH_TARGETS)
bench-quality: bench-build ## CPU time for pictures of equal quality, compared with POV-Ray; CORPUS=DIR: also for the course's scenes
	@mkdir -p out
	@bench/quality $(BUILD) $(SCENES) --out out/quality.json --runs $(or $(RUNS),2) $(if $(CORPUS),--corpus "$(CORPUS)")
bench-path: bench-build ## error and CPU time of path tracing, compared with Cycles; SCENES="FILE.xml ...": also for these, without glossy surfaces
	@scripts/install-deps interchange
	@bench/path $(BUILD) $(if $(SCENES),--scenes $(SCENES)) --out out/path.json
bench: bench-build ## CPU time and memory of renders and their parts, compared with POV-Ray; CORPUS=DIR: also for the course's scenes
	@mkdir -p out
	@bench/whole_runs $(BUILD) $(SCENES) --out out/bench.json --runs $(or $(RUNS),3) $(if $(CORPUS),--corpus "$(CORPUS)" --samples --all)
	@bench/curves $(BUILD) --out out/curves.json --runs $(or $(RUNS),3)
	@$(BUILD)/bench/scenefile_bench_kernels --benchmark_out=out/kernels.json --benchmark_out_format=json

.PHONY: docs
docs: build ## build the documentation site: out/site/index.html
	@scripts/install-deps docs
	@$(BUILD)/scenefile help --markdown > docs/diagnostics.md
	@$(BUILD)/scenefile help causes --markdown > docs/mistakes.md
	@scripts/library-reference $(BUILD)/installed-headers.txt
	@mkdocs build --quiet
	@echo "The site is in out/site; python3 -m http.server -d out/site shows it, with its search."

# The scripts of the page's folder need playwright, which npm installs there.
WEB_MODULES = [ -d web/node_modules/playwright-core ] || (cd web && npm ci --ignore-scripts --no-audit --no-fund)

.PHONY: screenshots
screenshots: build ## take the screenshots of the documentation again; that of the page needs "make web" first
	@scripts/install-deps tests browser
	@[ ! -f out/page/index.html ] || { $(WEB_MODULES); }
	@scripts/screenshots $(BUILD)

.PHONY: docs-test
docs-test: docs ## check that every link leads somewhere, every command shown runs, and the examples work
	@scripts/install-deps tests docs browser
	@tests/docs/pages.py links
	@tests/docs/pages.py commands $(BUILD)/scenefile
	@/usr/bin/python3 tests/docs/examples.py $(BUILD)/scenefile
	@$(WEB_MODULES)
	@node tests/docs/site.mjs out/site

.PHONY: interchange
interchange: build ## CORPUS=DIR: exported scenes pass the Khronos validator, and survive a trip through Blender
	@scripts/install-deps interchange
	@cd tests/interchange && npm ci --no-audit --no-fund
	@node tests/interchange/validate.js $(BUILD)/scenefile scenes $(CORPUS)
	@blender --background --factory-startup -noaudio --python-exit-code 1 --python tests/interchange/blender.py -- \
	  $(BUILD)/scenefile scenes $(CORPUS)

.PHONY: python
python: ## build the Python module, build/release/python/scenefile, and test it
	@scripts/install-deps core tests python
	@$(MAKE) $(QUIET) configure-tests
	@grep -qs SCENEFILE_PYTHON:BOOL=ON $(BUILD)/CMakeCache.txt || cmake $(PRESET) -DSCENEFILE_PYTHON=ON > /dev/null
	@cmake --build $(PRESET) --target scenefile scenefile_python
	@ctest --test-dir $(BUILD) --output-on-failure -L python --output-junit python.xml; status=$$?; \
	  scripts/test-summary $(BUILD)/python.xml && exit $$status

.PHONY: packages packages-tried
packages: ## create Debian packages for this system, and an archive for others: out/packages
	@scripts/install-deps core packages python
	@JOBS=$(JOBS) scripts/make-packages out/packages
packages-tried: packages ## SUITE=bookworm: install, test and remove the packages on a minimal Debian (needs root)
	@scripts/install-deps bare
	@scripts/bare-machine $(or $(SUITE),bookworm) --packages out/packages

.PHONY: container
IMAGE ?= scenefile
container: ## IMAGE=NAME: build a container of the program with docker or podman, and try it
	@packages/make-container "$(IMAGE)"

.PHONY: workflows
workflows: ## check the workflows and the action for GitHub
	@scripts/install-deps workflows
	@cd tests/workflows && npm ci --ignore-scripts --no-audit --no-fund --silent
	@node tests/workflows/check.js

.PHONY: editors
editors: build ## the language server in Neovim, Emacs, and VS Code's client, set up as docs/editors.md says
	@scripts/install-deps editors
	@cd editors/vscode && npm ci --ignore-scripts --no-audit --no-fund --silent
	@tests/editors/try.py $(CURDIR)/$(BUILD)/scenefile

.PHONY: install
install: build ## install to PREFIX (default /usr/local)
	$(call compile,scenefile_manual)
	@cmake --install $(BUILD) --prefix "$(or $(PREFIX),/usr/local)"

.PHONY: clean
clean: ## remove everything that was built
	@rm -rf build out
