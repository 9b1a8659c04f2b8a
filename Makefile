# Thin over CMake. `make help` lists what there is.

BUILD = build
PREFIX = /usr/local
CMAKE_FLAGS =
MINUTES = 1
fuzz_flags = -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined
sources = $(shell find lib tools tests -name '*.cpp' -o -name '*.h')

.PHONY: build demo check fuzz bench paper lint format install clean help configure

build: configure  ## the executables in build/bin (missing Debian packages are installed)
	@cmake --build $(BUILD) --target tools

demo: build  ## the whole pipeline on the demo scene: frames, movie, plot, POV-Ray, in build/demo
	@.ci/install demo
	@PATH="$(abspath $(BUILD))/bin:$$PATH" bash scenes/demo.sh scenes/room4 $(BUILD)/demo

check: configure  ## build and run all tests
	@.ci/install check
	@cmake -S . -B $(BUILD) -D STRAD_TESTS=ON >$(BUILD)/configure.log || { cat $(BUILD)/configure.log; false; }
	@cmake --build $(BUILD)
	@ctest --test-dir $(BUILD) --output-on-failure -j $$(nproc)

fuzz:  ## MINUTES=n (default 1) of fuzzing for each target, with sanitizers; finds are in build/fuzz/finds
	@.ci/install build lint
	@mkdir -p $(BUILD)/fuzz
	@test -f $(BUILD)/fuzz/build.ninja || CXX=clang++ cmake -G Ninja -S . -B $(BUILD)/fuzz -D STRAD_FUZZ=ON -D STRAD_TESTS=ON \
	  -D CMAKE_BUILD_TYPE=RelWithDebInfo -D CMAKE_CXX_FLAGS="-O1 -fno-omit-frame-pointer $(fuzz_flags)" >$(BUILD)/fuzz/log \
	  || { cat $(BUILD)/fuzz/log; false; }
	@cmake --build $(BUILD)/fuzz --target fuzzers
	@bash tests/fuzz/fuzz.sh $(BUILD)/fuzz $(MINUTES)

bench: build  ## error against CPU seconds, acceleration, continuity, as tables
	@.ci/install bench
	@PATH="$(abspath $(BUILD))/bin:$$PATH" bash tests/bench/bench.sh

paper: build  ## tables and figures of the 2001 paper made again, as one page: build/paper/index.html
	@.ci/install bench
	@PATH="$(abspath $(BUILD))/bin:$$PATH" bash tests/paper/paper.sh $(BUILD)/paper

lint:  ## formatting, man pages, types defined twice, clang's warnings and clang-tidy for lib/ and tools/
	@.ci/install build lint
	@clang-format --dry-run --Werror $(sources)
	@mandoc -T lint -W warning man/*.[157]
	@for claim in type_names_are_unique folders_include_no_circles; do \
	  STRAD_SOURCE_DIR=$(CURDIR) bash -eu -o pipefail tests/pipelines/house_$$claim.sh || exit 1; done
	@mkdir -p $(BUILD)/lint
	@CXX=clang++ cmake -G Ninja -S . -B $(BUILD)/lint -D STRAD_TESTS=OFF >$(BUILD)/lint/log || { cat $(BUILD)/lint/log; false; }
	@find lib tools -name '*.cpp' | xargs -P $$(nproc) -n 4 clang-tidy -quiet -p $(BUILD)/lint 2>/dev/null

format:  ## lay out the sources by .clang-format
	@.ci/install lint
	@clang-format -i $(sources)

install: build  ## into PREFIX (default /usr/local) below DESTDIR
	@DESTDIR="$(DESTDIR)" cmake --install $(BUILD) --prefix "$(PREFIX)"

clean:  ## remove all that was built
	@rm -rf $(BUILD)

help:  ## this list
	@sed -n 's/^\([a-z]*\):.*  ## /\1\t/p' $(firstword $(MAKEFILE_LIST)) | expand -t 10

configure:
	@.ci/install build
	@mkdir -p $(BUILD)
	@test -f $(BUILD)/build.ninja || cmake -G Ninja -S . -B $(BUILD) -D STRAD_TESTS=OFF $(CMAKE_FLAGS)
