# SPDX-FileCopyrightText: 2026 The ClusterVO-bench authors
# SPDX-License-Identifier: Apache-2.0
# The front door: every target installs, configures and builds what it needs, and does none of it
# twice. `make` lists the targets.
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.NOTPARALLEL:
.PHONY: help deps build program deb demo report table table-all table-kitti sweep record record-quick record-status regression baseline test fuzz bench asan asan-variants tsan valgrind format format-check lint clean

release := build/release
asan := build/asan
lint := build/lint
folders := $(wildcard core variants experiments synth reports tests)
sources = $(shell find $(folders) -name '*.h' -o -name '*.cc')
baseline := reports/baselines/ci.json
# Compilers, and jobs of a suite, to run at once; empty: one per processor.
JOBS ?=
jobs := $(if $(JOBS),--parallel $(JOBS))

# What the two commands are about to do; times are of two idle cores.
about_test := install missing packages, build everything (14 minutes from nothing), run the tests (10 minutes)
about_demo := install missing packages, build the program (6 minutes from nothing), render and run one room (20 s)
about_table := install missing packages, build the program (6 minutes from nothing), render the rooms of \
  the test split and run the ablation on them (20 minutes)
$(foreach goal,$(filter demo test table,$(MAKECMDGOALS)),$(info make $(goal): $(about_$(goal))))

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/make \1|\2/p' Makefile | awk -F'|' '{printf "%-18s %s\n", $$1, $$2}'

deps: ## install what is missing of the Debian packages that program and tests need (packages.txt)
	@.ci/install-packages program tests

# The program needs fewer packages than the tests.
.PHONY: packages
packages:
	@.ci/install-packages program

# Ninja configures again by itself when a CMakeLists.txt changes.
build/%/build.ninja: CMakePresets.json | packages
	cmake --preset $* -DCMAKE_CXX_COMPILER_LAUNCHER="$$(command -v ccache)"

# Exists where GoogleTest was there when the build was configured.
build/%/CTestTestfile.cmake: | build/%/build.ninja
	cmake --preset $*
	@test -e $@ || { echo "make: no GoogleTest: install it (packages.txt)" >&2; exit 1; }

.PRECIOUS: build/%/build.ninja
build: deps $(release)/CTestTestfile.cmake ## build everything, Release
	cmake --build --preset release $(jobs)

# The program, and the Python package where its packages are; no tests and benchmarks.
program: $(release)/build.ninja
	cmake --build --preset release $(jobs) --target clustervo \
	  $$(grep -qs '^build cvo_python:' $(release)/build.ninja && echo cvo_python)

# A suite to results/<suite>: what is done there is not done again. Its table is printed also where
# some jobs failed, which the exit code then says.
suite = $(release)/bin/clustervo experiment run $(1) -o results/$(1) $(addprefix -j ,$(JOBS)) \
	$(if $(DATA),--data "$(DATA)"); code=$$?; test $$code -le 1 || exit $$code; \
	$(release)/bin/clustervo experiment table results/$(1) && \
	echo "page: results/$(1)/report/index.html, written by: make report SUITE=$(1)" && exit $$code

demo: program ## render one room, run two variants on it, draw a picture and write a page
	@$(call suite,demo)
	@$(release)/bin/clustervo report results/demo
	@$(release)/bin/clustervo overlay --suite results/demo --sequence room_3 --frame 40 -o results/demo/pictures -q

deb: program ## pack the program and its Python package for other machines: build/release/clustervo_*.deb
	@.ci/install-packages dpkg-dev file
	@cd $(release) && cpack -G DEB

table: program ## the paper's ablation on rooms of the test split, end to end: its table, and results/ablation
	@$(call suite,ablation)

table-all: program ## the main variants and ablations on the development rooms
	@$(call suite,ablation_all)

table-kitti: $(if $(DATA),program) ## DATA=<KITTI folder>: the table of KITTI raw, of the drives found
	$(if $(DATA),,$(error make table-kitti: give DATA=<KITTI folder>))
	@$(call suite,kitti_raw)

sweep: program ## one table per parameter that is swept
	@$(call suite,sweep_alpha)
	@$(call suite,sweep_eta)
	@$(call suite,sweep_windows)
	@$(call suite,sweep_motion_prior)
	@$(call suite,sweep_association)

# What the documents quote. Test scenes are drawn here alone; `make record` goes on where it stopped,
# and leaves out a suite of which jobs failed.
record := reports/RESULTS.md
recorded := $(shell awk '!/^\#/{print $$1}' reports/record.txt)
sampled := $(shell awk '$$3 == "quick"{print $$1}' reports/record.txt)
minutes = $(shell awk '!/^\#/ && $$3 ~ "$(1)"{n += $$2} END{print n}' reports/record.txt)
# A suite to a folder; its table in Markdown.
recorded_run = $(release)/bin/clustervo experiment run $(1) -o $(2) --data "$(DATA)" $(addprefix -j ,$(JOBS)) $(3)
recorded_table = $(release)/bin/clustervo experiment table $(1) --format markdown
# A figure of a suite to reports/record, and the line that shows it.
recorded_figure = $(release)/bin/clustervo plot results/$(1) --only $(2) -o results/$(1)/figures > /dev/null && \
  mkdir -p reports/record && cp results/$(1)/figures/$(2).svg reports/record/$(1).svg && \
  printf '![%s](record/%s.svg)\n\n' $(1) $(1)
$(foreach goal,$(filter record record-quick,$(MAKECMDGOALS)),$(if $(DATA),$(info make $(goal): \
  $(call minutes,$(if $(filter record-quick,$(goal)),quick)) minutes on two idle cores (reports/record.txt)),\
  $(error make $(goal): give DATA=<KITTI folder>)))
# The section of $suite in the record.
recorded_section = awk '/^\#\# / {on = $$2 == "'$$suite'"} on' $(record)
# What follows from all sections: the line on top and the documents' tables.
record_made = .ci/record-status $(record) $(release)/bin/clustervo true made && \
  .ci/quote-record $(record) $$(grep -rl '^<!-- record: ' --include='*.md' README.md core experiments)
record: program ## DATA=<KITTI folder>: run what the documents quote; writes reports/RESULTS.md and their tables
	@build=$$($(release)/bin/clustervo --version | sed -n 's/^build *\(.\{12\}\).*/\1/p'); \
	code=0; for suite in $(recorded); do \
	  ! $(recorded_section) | grep -q "; build $$build$$" || continue; \
	  $(call recorded_run,$$suite,results/$$suite) || { code=$$?; test $$code -eq 1 || exit $$code; continue; }; \
	  { sed "/^## $$suite$$/,\$$d" $(record); \
	    printf '## %s\n\n' $$suite; $(call recorded_table,results/$$suite) || test $$? -eq 1 || exit 2; echo; \
	    case $$suite in pareto*) $(call recorded_figure,$$suite,pareto);; esac; \
	    awk '/^## / && on == 1 {on = 2} $$0 == "## '$$suite'" {on = 1} on == 2' $(record); \
	  } > $(record).new && mv $(record).new $(record) && $(record_made) || exit 1; \
	done; exit $$code

record-quick: program ## DATA=<KITTI folder>: run a sample of the record again and compare: results/record_quick
	@mkdir -p results/record_quick; code=0; for suite in $(sampled); do \
	  $(call recorded_run,$$suite,results/record_quick/$$suite,-q > /dev/null) || exit 2; \
	  $(call recorded_table,results/record_quick/$$suite) > results/record_quick/$$suite.table; \
	  .ci/compare-record $(record) $$suite results/record_quick/$$suite.table || code=1; \
	done; exit $$code

record-status: program ## of what build reports/RESULTS.md is, what differs, and whether values have moved; it says so on top
	@.ci/record-status $(record) $(release)/bin/clustervo "$(MAKE) regression"

# The page is also made where jobs failed, and says so.
SUITE ?= ablation
report: program ## the results of make table as one page: results/ablation/report/index.html (SUITE=<name>)
	@test -e results/$(SUITE)/plan.json || \
	  { echo "make report: no results/$(SUITE): run the suite first (make table)" >&2; exit 2; }
	@$(release)/bin/clustervo report results/$(SUITE)

# Jobs that failed are told of by the check too.
regression: program ## run the suite ci and hold it against the committed baseline
	@$(release)/bin/clustervo experiment run ci -o results/ci $(addprefix -j ,$(JOBS)); \
	code=$$?; test $$code -le 1 || exit $$code; \
	$(release)/bin/clustervo check results/ci --baseline $(baseline) --junit results/ci/check.xml \
	  --markdown results/ci/check.md

# Sixteen seeds tell how far seeds are apart; a check runs the suite's own two.
baseline: program ## accept what the estimator does now: update the baseline of make regression
	$(release)/bin/clustervo experiment run ci --seeds 16 -o results/ci_seeds $(addprefix -j ,$(JOBS))
	$(release)/bin/clustervo check results/ci_seeds --write-baseline $(baseline) --gate-seeds 2

test: build ## run the tests; CLUSTERVO_DATA=<folder> adds those on real data
	@code=0; ctest --preset release --output-junit "$(CURDIR)/$(release)/tests.xml" || code=$$?; \
	sed -n '/: Skipped$$/{n;p}' $(release)/Testing/Temporary/LastTest.log | sort | uniq -c | sed 's/^ */skipped: /'; \
	exit $$code

# libFuzzer with sanitizers. What it learns and finds stays in build/fuzz/attack/<parser>; the next call goes on from there.
RUNS ?= 1000000
SECONDS ?= 0
PARSER ?= .*
.PHONY: clang
clang:
	@.ci/install-packages clang libclang-rt-dev
fuzz: clang deps build/fuzz/CTestTestfile.cmake ## give every parser RUNS=1000000 spoilt files, for SECONDS=n at most (PARSER=suite: that one)
	cmake --build --preset fuzz --target fuzz_target $(jobs)
	mkdir -p build/fuzz/attack
	cd build/fuzz/attack && ../tests/faults/fuzz_target seeds . | grep -xE '$(PARSER)' | \
	  xargs -P $(or $(JOBS),$$(nproc)) -I@ ../tests/faults/fuzz_target @ -runs=$(RUNS) -max_total_time=$(SECONDS) \
	  -timeout=20 -verbosity=0 -print_final_stats=1 -artifact_prefix=@/finding- @/corpus @/seeds

# With KITTI: drive 0013 with its boxes; without, a rendered scene.
drive := $(DATA)/kitti_raw/2011_09_26/2011_09_26_drive_0013_sync
bench: build ## time of a frame, as ratios to decoding and OpenCV's ORB (DATA=<KITTI folder>)
	cmake --build --preset release --target frame_time $(jobs)
	$(if $(DATA),,$(release)/bin/clustervo synth render crowd -o $(release)/bench/crowd)
	$(release)/tests/bench/frame_time $(if $(DATA),$(drive) $(DATA)/kitti_tracking/training/det_02_regionlets/0003.txt 2,$(release)/bench/crowd good)

# Two thirds of the tests are the same ones for every variant; each half ends within the hour.
asan: deps $(asan)/CTestTestfile.cmake ## build with address and undefined-behaviour sanitizers, run the tests
	cmake --build --preset asan $(jobs)
	GTEST_FILTER="-*/EveryVariant*" ctest --preset asan

asan-variants: deps $(asan)/CTestTestfile.cmake ## the same for the tests that every variant must pass
	cmake --build --preset asan $(jobs)
	GTEST_FILTER="*/EveryVariant*" ctest --preset asan --tests-regex odometry_

# The pool of threads, what renders with it, what reads and keeps files with it, and runs that look ahead.
threaded := base_test synth_dataset_test cache_test datasets_test features_test runner_test
tsan: deps build/tsan/CTestTestfile.cmake ## build with the thread sanitizer, run the tests of what has threads
	cmake --build --preset tsan --target $(threaded) $(jobs)
	cd build/tsan && export TSAN_OPTIONS="suppressions=$(CURDIR)/tests/support/tsan.supp" && \
	  find tests -name '*_test' -type f | sort | while read -r t; do "$$t" || exit 1; done

# Values that were never set, which the sanitizers above do not see: in the programs that end in minutes.
memchecked := base_test files_test geometry_test log_test association_test estimation_test clustering_test \
  clustering_unary_test features_test odometry_parts_test metrics_test statistics_test tables_test record_test runs_test gate_test
valgrind: deps $(release)/CTestTestfile.cmake ## run tests under valgrind, which finds values that were never set (minutes)
	@.ci/install-packages valgrind
	cmake --build --preset release --target $(memchecked) $(jobs)
	cd $(release) && for t in $(memchecked); do \
	  valgrind -q --error-exitcode=1 "$$(find tests -name $$t -type f)" --gtest_brief=1 || exit 1; done

format: ## format all C++ sources in place
	@.ci/install-packages clang-format
	@clang-format -i $(sources)

format-check: ## fail where a source is not formatted
	@clang-format --dry-run -Werror $(sources)

# Of sources by themselves, not joined.
lint: deps $(lint)/CTestTestfile.cmake ## run clang-tidy on all C++ sources (minutes)
	@.ci/install-packages clang-tidy
	cmake --build $(lint) --target cvo_generated
	run-clang-tidy -quiet -extra-arg=-Wno-unknown-warning-option -p $(lint) '$(CURDIR)/($(subst $() ,|,$(strip $(folders))))/'

clean: ## remove everything that was built
	rm -rf build
