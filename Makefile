# glasspipe: a software GPU of the 2005 class that gives the same bits everywhere.
# `make help` says what there is to make. Everything made goes below out/.

# --- what a user may set --------------------------------------------------------------------------

BUILD    ?= out
OPT      ?= -O2
SANITIZE ?=
WERROR   ?=
PREFIX   ?= /usr/local
DESTDIR  ?=
ARCH     ?= $(shell uname -m)
EMULATOR ?=
ifeq ($(origin CC),default)
CC := gcc
endif
ifeq ($(origin CXX),default)
CXX := g++
endif

# All processors, unless a -j was given; inner makes share what the outer one has.
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell nproc)
endif
MAKEFLAGS += --no-builtin-rules
.DELETE_ON_ERROR:
.SECONDARY:

ifeq ($(V),)
say = @printf '  %-5s %s\n' $(1) $(2);
endif

# --- flags

# Shaders are built here as anywhere: by the file that users get.
comma      := ,
GP_OBJECTS := $(BUILD)/obj/
FLAGS_FILE := $(BUILD)/obj/flags
GP_NEEDS   := $(FLAGS_FILE) | packages
GP_SHADERS := $(sort $(shell find shaders_c tests/shaders -name '*.c'))
GP_ARCH    := $(ARCH)
ifdef ISAS
GP_ISAS    := $(ISAS)
endif
GP_SAY      = $(say)
GP_COMPILE  = $(ALL_C)
GP_COMPILE_COUNT = $(COUNT_CXX)
include pipeline/install/shaders.mk
ISAS       := $(GP_ISAS)
VARIANTS   := $(GP_VARIANTS)
# Which are no shaders, but compiled for each width all the same; -O3 makes meshes 4 to 11 % quicker. Fields that
# gcc stores together are read one by one, and wait: points take 5 % less without, with AVX2 all a little.
$(BUILD)/obj/pipeline/fast/lanes/%.o: GP_SHADER_OPT := $(if $(filter -O2,$(OPT)),-O3 -fno-tree-slp-vectorize)

WARNINGS := -Wall -Wextra -Wshadow -Wconversion -Wdouble-promotion -Wno-psabi$(if $(GP_IS_CLANG), -Wno-missing-field-initializers) \
            $(if $(WERROR),-Werror)
SANITIZER := $(if $(SANITIZE),-fsanitize=$(SANITIZE) -fno-sanitize-recover=all \
                              -fno-omit-frame-pointer)
COMMON   := $(OPT) -g -fPIC -pthread -I. -Ipipeline $(GP_MODEL) $(WARNINGS) $(SANITIZER) -MMD -MP
# The hash is compiled in from xxhash's header: no library to find at run time.
COMMON   += -DXXH_INLINE_ALL
ALL_C    := $(CC) -std=gnu11 -Werror=implicit-function-declaration $(COMMON) $(CPPFLAGS) $(CFLAGS)
ALL_CXX  := $(CXX) $(COMMON) $(CPPFLAGS) $(CXXFLAGS)
# Libraries' own headers are not ours to warn about.
IO_CXX   := $(ALL_CXX) -std=gnu++17 -Wno-conversion -Wno-double-promotion -Wno-shadow
# Without exceptions, and types that are looked at as it runs, it needs no library of C++.
COUNT_CXX := $(ALL_CXX) -std=gnu++20 -fno-exceptions $(if $(and $(SANITIZE),$(GP_IS_CLANG)),-fno-sanitize=function$(comma)vptr) -x c++
LINK     := $(CC) -pthread $(SANITIZER) $(LDFLAGS)
LINK_CXX := $(CXX) -pthread $(SANITIZER) $(LDFLAGS)
# Clang counts how often each branch of the pipeline is taken: make coverage. Local functions are told apart by
# the name of their file, which is to be whole, since there are two of blend.c.
ifdef COVERAGE
$(BUILD)/obj/pipeline/%.o: ALL_C += -fprofile-instr-generate -fcoverage-mapping -Xclang -main-file-name -Xclang $<
LINK     += -fprofile-instr-generate
LINK_CXX += -fprofile-instr-generate
endif
# libFuzzer looks at every counter after each run: none where no file is read, which is four fifths of them, and
# comparisons only in readers. Looking took 78 of 100 of the time of options, and 39 of meshes.
ifneq ($(findstring fuzzer,$(SANITIZE)),)
NO_COMPARISONS := -fno-sanitize-coverage=trace-cmp
NO_COUNTERS    := -fno-sanitize-coverage=trace-cmp,inline-8bit-counters,indirect-calls,pc-table
$(addprefix $(BUILD)/obj/pipeline/,fast/%.o reference/%.o units/%.o list/%.o): ALL_C += $(NO_COMPARISONS)
$(addprefix $(BUILD)/obj/,shaders_c/%.o tests/%.o): ALL_C += $(NO_COUNTERS)
$(BUILD)/obj/shaders_c/%.o: COUNT_CXX += $(NO_COUNTERS)
endif
WITH_OIIO ?= 1
WITH_OPENMESH ?= 1
IO_LIBS  ?= -ljansson -lpng -lz
# Programs find the libraries that they load beside them. By RPATH where sanitizers stand between dlopen
# and its caller, whose RUNPATH then does not count.
BESIDE   := $(if $(SANITIZE),-Wl$(comma)--disable-new-dtags) '-Wl,-rpath,$$ORIGIN/../lib'
# What shaders of a user's own, which are loaded, call to be counted.
EXPORTED := '-Wl,--export-dynamic-symbol=gp_graph_*'
LIBS     := $(if $(CXX),$(IO_LIBS) $(BESIDE) $(EXPORTED)) -lm

# Shaders may share structs by headers; the counting lanes inside them are each object's own.
COUNT_CXX += $(if $(GP_IS_CLANG),,-Wno-subobject-linkage)

# Which widths there are, for the files that list them.
ALL_C += $(foreach isa,$(ISAS),\
           '-DGP_LANES$(word 1,$(subst :, ,$(isa)))_ISA="$(word 2,$(subst :, ,$(isa)))"')

# --- what there is to build -----------------------------------------------------------------------

VERSION := $(shell sed -n 's/^.define GP_VERSION "\(.*\)"/\1/p' pipeline/glasspipe/glasspipe.h)
SONAME  := libglasspipe.so.$(firstword $(subst ., ,$(VERSION)))

object = $(patsubst %,$(BUILD)/obj/%.o,$(basename $(1)))
# All files below a folder whose names end so: $(call below,apps,*.c)
below = $(sort $(shell find $(1) -name '$(2)'))

LANES   := $(call below,pipeline/fast/lanes,*.c)
CORE    := $(call object,$(filter-out $(LANES) pipeline/io/%,$(call below,pipeline,*.c))) \
           $(foreach isa,$(ISAS),$(patsubst %.c,$(BUILD)/obj/%.lanes$(firstword $(subst :, ,$(isa))).o, \
                                            $(LANES)))
# OpenImageIO is loaded when a picture needs it, OpenMesh when a mesh is simplified: libraries of their own.
OIIO    := pipeline/io/image/oiio_library.cpp pipeline/io/image/oiio_layers.cpp
OPENMESH := pipeline/io/mesh/simplify_openmesh.cpp
IO      := $(call object,$(call below,pipeline/io,*.c))
SHADERS := $(call object,$(call below,shaders_c,*.c))
MAIN    := $(addprefix $(BUILD)/obj/,apps/main.o apps/program.o)
APPS    := $(call object,$(filter-out apps/main.c apps/program.c apps/mpi/%,$(call below,apps,*.c)) apps/inspect/page_files.c)
MPI     := $(call object,$(call below,apps/mpi,*.c))
# What stands in the program as it is: pages, and the sources that they show.
PAGE_FILES := $(sort $(call below,apps/inspect/page,*.*) $(wildcard pipeline/units/*.c) pipeline/list/needs.c \
                $(call below,shaders_c,*.[ch]))
SUPPORT := $(call object,$(call below,tests/support,*.c))
TEST_SHADERS := $(call object,$(wildcard tests/shaders/*.c))
FUZZ    := $(call object,$(filter-out tests/fuzz/libfuzzer.c,$(wildcard tests/fuzz/*.c)))
GOLDEN  := $(call object,$(wildcard tests/golden/*.c))
DIFFERENTIAL := $(call object,$(wildcard tests/differential/*.c))

PROGRAM := $(BUILD)/bin/glasspipe
MPI_PROGRAM := $(BUILD)/bin/glasspipe-mpi
MPICC   ?= mpicc
MPIRUN  ?= mpirun
HEADERS := $(BUILD)/include/glasspipe/glasspipe.h
# What stands in out/ as it will be installed, so that programs can be built from either.
STAGED  := $(HEADERS) $(addprefix $(BUILD)/,share/glasspipe/shaders.mk lib/pkgconfig/glasspipe.pc \
                                            share/glasspipe/build_shader.sh lib/cmake/glasspipe/glasspipe-config.cmake)
CORE_A  := $(BUILD)/lib/libglasspipe.a
CORE_SO := $(BUILD)/lib/libglasspipe.so
IO_A    := $(BUILD)/lib/libglasspipe_io.a
OIIO_SO := $(if $(WITH_OIIO),$(BUILD)/lib/libglasspipe_oiio.so)
OPENMESH_SO := $(if $(WITH_OPENMESH),$(BUILD)/lib/libglasspipe_openmesh.so)
LOADED  := $(OIIO_SO) $(OPENMESH_SO)
APPS_A  := $(BUILD)/obj/apps.a
SHADERS_A := $(BUILD)/obj/shaders.a
SUPPORT_A := $(BUILD)/obj/support.a

# Test programs, by their source's name. The golden frames need nothing but the core and the
# shaders, so that they can be drawn on a processor that has no libraries.
# The slowest program first, so that it runs beside the others.
TEST_SOURCES := $(call below,tests/cli,test_*.c) $(call below,tests/unit,test_*.c)
TESTS        := $(patsubst %.c,$(BUILD)/test/%,$(notdir $(TEST_SOURCES)))
GOLDEN_TEST  := $(if $(GOLDEN),$(BUILD)/test/golden)
DIFFERENTIAL_TEST := $(BUILD)/test/differential
KERNELS      := $(patsubst %.c,$(BUILD)/test/%,$(notdir $(wildcard tests/kernel/check_*.c)))

.PHONY: all program mpi run deps deps-mpi faults test lint check check-peer docs format install uninstall help clean bless
all: program $(CORE_SO) $(CORE_A) $(STAGED)
program: $(PROGRAM)
mpi: $(MPI_PROGRAM)

# --- packages -------------------------------------------------------------------------------------

PACKAGES = CC='$(CC)' CXX='$(CXX)' CPPFLAGS='$(CPPFLAGS)' sh tests/tools/packages.sh

# Everything compiled waits for this: it installs what is missing where the goal is to do so, and
# otherwise says what to install. Cheap when nothing is missing.
.PHONY: packages
packages:
ifeq ($(MAKELEVEL),0)
ifneq ($(filter run test check check-peer bench-peers differential,$(MAKECMDGOALS)),)
	@$(PACKAGES) install build $(if $(filter-out run,$(MAKECMDGOALS)),test) \
	    $(if $(filter check,$(MAKECMDGOALS)),lint check)
else
	@$(PACKAGES) report build $(if $(filter bless,$(MAKECMDGOALS)),test) $(filter lessons,$(MAKECMDGOALS))
endif
else
	@:
endif

deps:
	@$(PACKAGES) install build test lint
deps-mpi:
	@$(PACKAGES) install build mpi

# --- compiling ------------------------------------------------------------------------------------

# Rebuilds everything when the compiler or its flags change.
FLAGS_TEXT := $(subst ','"'"',$(ALL_C) | $(COUNT_CXX) | $(LINK) | $(ISAS) | $(GP_SHADER_OPT))
.PHONY: always
$(FLAGS_FILE): always | packages
	@mkdir -p $(@D)
	@[ -e $@ ] || { n=$$(nproc); \
	    echo "first build: about $$(((8 + n - 1) / n)) min on $$n processors, this once"; }
	@echo '$(FLAGS_TEXT)' | cmp -s - $@ || echo '$(FLAGS_TEXT)' >$@

$(BUILD)/obj/%.o: %.c $(FLAGS_FILE) | packages
	@mkdir -p $(@D)
	$(call say,CC,$<)$(ALL_C) -c $< -o $@

$(BUILD)/obj/apps/inspect/page_files.c: apps/inspect/page_files.sh $(PAGE_FILES)
	@mkdir -p $(@D)
	@sh $< $(PAGE_FILES) >$@
$(BUILD)/obj/apps/inspect/page_files.o: $(BUILD)/obj/apps/inspect/page_files.c $(FLAGS_FILE)
	$(call say,CC,$<)$(ALL_C) -c $< -o $@

$(BUILD)/obj/%.o: %.cpp $(FLAGS_FILE) | packages
	@mkdir -p $(@D)
	$(call say,CXX,$<)$(IO_CXX) -c $< -o $@

# --- libraries and programs -----------------------------------------------------------------------

# Appended, not replaced: files of two folders may have one name.
define archive
	@mkdir -p $(@D)
	@rm -f $@
	$(call say,AR,$@)$(AR) qcs $@ $^
endef
$(CORE_A): $(CORE)
	$(archive)
$(IO_A): $(IO)
	$(archive)
$(APPS_A): $(APPS)
	$(archive)
$(SHADERS_A): $(SHADERS)
	$(archive)
$(SUPPORT_A): $(SUPPORT) $(TEST_SHADERS)
	$(archive)

$(CORE_SO): $(CORE)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) -shared -Wl,-soname,$(SONAME) $^ -lm -o $@.$(VERSION)
	@ln -sf $(notdir $@).$(VERSION) $(@D)/$(SONAME)
	@ln -sf $(SONAME) $@

$(OIIO_SO): $(call object,$(OIIO) pipeline/io/image/image.c pipeline/io/image/layers.c pipeline/base/base.c)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK_CXX) -shared $^ -lOpenImageIO -lOpenImageIO_Util -o $@

# Its classes are never told apart by type, and some have none to be told by.
$(call object,$(OPENMESH)): IO_CXX += $(if $(SANITIZE),-fno-sanitize=vptr)
$(OPENMESH_SO): $(call object,$(OPENMESH) pipeline/base/base.c)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK_CXX) -shared $^ -lOpenMeshCore -o $@

$(PROGRAM): $(MAIN) $(APPS_A) $(SHADERS_A) $(IO_A) $(CORE_A) | $(LOADED) $(STAGED)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $^ $(LIBS) -o $@

# A program of its own, of which the other one knows nothing: with Open MPI or MPICH, by the compiler that
# all else is built with.
MPI_FLAGS = $$($(MPICC) -showme:$(1) 2>/dev/null || $(MPICC) -$(1)-info | cut -d' ' -f2-)
.PHONY: mpi-packages
mpi-packages:
	@command -v $(MPICC) >/dev/null || { echo "no $(MPICC): make deps-mpi installs Open MPI" >&2; exit 1; }
$(MPI): $(BUILD)/obj/%.o: %.c $(FLAGS_FILE) | packages mpi-packages
	@mkdir -p $(@D)
	$(call say,CC,$<)$(ALL_C) $(call MPI_FLAGS,compile) -c $< -o $@

$(MPI_PROGRAM): $(MPI) $(filter-out %/main.o,$(MAIN)) $(APPS_A) $(SHADERS_A) $(IO_A) $(CORE_A) | $(LOADED) $(STAGED)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $^ $(LIBS) $(call MPI_FLAGS,link) -o $@

# What users include, laid out as it is installed: the two public headers and what they include,
# which find each other by <glasspipe/...> alone.
public_headers = $(sort $(filter pipeline/%,$(shell for header in glasspipe shader effect; do \
    $(CC) -I. -Ipipeline -std=gnu11 -MM pipeline/glasspipe/$$header.h; \
    $(CXX) -I. -Ipipeline -std=gnu++20 -x c++ -MM pipeline/glasspipe/$$header.h; done)))
$(HEADERS): Makefile $(call below,pipeline,*.h) $(call below,pipeline,*.hpp) | packages
	@rm -rf $(@D)
	$(call say,STAGE,$(@D))for header in $(public_headers); do \
	    to=$${header#pipeline/}; to=$(@D)/$${to#glasspipe/}; mkdir -p $${to%/*}; \
	    sed 's,#include "pipeline/\(.*\)",#include <glasspipe/\1>,' $$header >$$to || exit; done

$(filter-out $(HEADERS),$(STAGED)): $(wildcard pipeline/install/*)
	@mkdir -p $(@D)
	@sed 's,@VERSION@,$(VERSION),' pipeline/install/$(@F) >$@

# --- the first picture ----------------------------------------------------------------------------

run: all
	@$(PROGRAM) render scenes/together.json -o out/together.png
	@$(PROGRAM) explain scenes/together.json >out/together.txt
	@echo "picture: out/together.png"
	@echo "report:  out/together.txt (what each draw needed, and what its shaders cost)"

# --- lessons --------------------------------------------------------------------------------------

# "Break it": programs of which one line of a unit is another, by a patch. Linked before the library,
# the changed unit stands for its own.
BREAKS := $(patsubst scenes/lessons/break/%.patch,$(BUILD)/break/%,$(wildcard scenes/lessons/break/*.patch))
$(BUILD)/break/%.c: scenes/lessons/break/%.patch $(wildcard pipeline/units/*.c)
	@mkdir -p $(@D)
	@patch -s -f -F0 -r - -o $@ "$$(sed -n 's,^+++ b/,,p' $<)" $< || \
	    { echo "$<: does not apply to the present source" >&2; exit 1; }
$(BREAKS:=.o): %.o: %.c $(FLAGS_FILE)
	$(call say,CC,$<)$(ALL_C) -c $< -o $@
$(BREAKS): %: %.o $(MAIN) $(APPS_A) $(SHADERS_A) $(IO_A) $(CORE_A)
	$(call say,LINK,$@)$(LINK) -Wl,-s $^ $(LIBS) -o $@

.PHONY: lessons
lessons: $(PROGRAM) $(BREAKS)
	@mkdir -p out/lessons
	@sh tests/tools/break_it.sh page $(PROGRAM) $(BUILD)/break out/lessons/break_it.html
	@$(PROGRAM) inspect -q --no-timings --lesson scenes/lessons -o out/lessons
	@echo "lessons: out/lessons/index.html"

# --- tests

# All that tests look at, in one shared library: a change relinks in a moment.
TESTED_SO := $(BUILD)/test/libtested.so
$(TESTED_SO): $(SUPPORT) $(FUZZ) $(TEST_SHADERS) $(APPS) $(SHADERS) $(IO) $(CORE) | $(LOADED)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) -shared $^ $(LIBS) -o $@

define test_program
$(BUILD)/test/$(basename $(notdir $(1))): $(call object,$(1)) $(TESTED_SO)
	@mkdir -p $$(@D)
	$$(call say,LINK,$$@)$$(LINK) $$< -L$(BUILD)/test -ltested '-Wl,-rpath,$$$$ORIGIN' -lcmocka \
	    $$(LIBS) -o $$@
endef
$(foreach source,$(TEST_SOURCES),$(eval $(call test_program,$(source))))

$(DIFFERENTIAL_TEST): $(DIFFERENTIAL) $(SUPPORT_A) $(SHADERS_A) $(CORE_A)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $^ -lm -o $@

$(GOLDEN_TEST): $(GOLDEN) $(SUPPORT_A) $(SHADERS_A) $(CORE_A)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $^ -lm -o $@

$(BUILD)/test/check_channels: $(foreach isa,$(ISAS), \
    $(BUILD)/obj/tests/kernel/channels.lanes$(firstword $(subst :, ,$(isa))).o)
$(KERNELS): $(BUILD)/test/%: $(BUILD)/obj/tests/kernel/%.o $(CORE_A)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $^ -lm -o $@

RUN_TEST = BUILD=$(BUILD) GLASSPIPE_BIN=$(PROGRAM) EMULATOR='$(EMULATOR)' sh tests/tools/run_test.sh
# Every lane width that was built; a processor that lacks one says "skipped" when it is run.
WIDTHS := $(filter lanes%,$(VARIANTS))
GOLDEN_RESULTS = $(foreach width,$(WIDTHS),$(GOLDEN_TEST:%=%.$(width).tap))
# Models of x86 processors, with the widths that they have: a short form of the tests runs as these,
# which are not here, and `make check` runs all of them so.
OTHER_PROCESSORS := Nehalem:4 Haswell-noTSX:4,8
OTHER_RESULTS := $(if $(filter x86_64,$(ARCH)),$(if $(EMULATOR)$(SANITIZE),,$(patsubst %, \
    $(BUILD)/test/as.%.tap,$(foreach p,$(OTHER_PROCESSORS),$(firstword $(subst :, ,$(p)))))))
PICTURE_RESULT := $(BUILD)/test/pictures.tap
PRINTED_RESULT := $(BUILD)/test/printed.tap
# What users get, in short; `make check` has all of it.
LIBRARY_RESULT := $(if $(EMULATOR)$(SANITIZE),,$(BUILD)/test/library.tap $(BUILD)/test/headers.tap)
# What a stranger's compiler says of shaders, and makes of them.
SNIPPET_RESULT := $(if $(EMULATOR)$(SANITIZE),,$(BUILD)/test/snippets.tap)
# Changed units still apply, and change the picture.
BREAK_RESULT := $(if $(EMULATOR)$(SANITIZE),,$(BUILD)/test/break_it.tap)
# Pages in a browser, where there is one.
INSPECT_RESULT := $(if $(EMULATOR)$(SANITIZE),,$(BUILD)/test/inspect.tap $(BUILD)/test/lessons.tap)
MPI_RESULT := $(if $(EMULATOR)$(SANITIZE),,$(BUILD)/test/mpi.tap)
# Lanes as processors have them for which there are no intrinsics.
PLAIN_RESULT := $(if $(EMULATOR)$(SANITIZE)$(COVERAGE),,$(BUILD)/test/plain_lanes.tap)
# Calls that fail: sanitizers and emulators have allocators of their own.
FAULT_RESULT := $(if $(EMULATOR)$(SANITIZE),,$(BUILD)/test/faults.tap)
RESULTS  = $(DIFFERENTIAL_TEST).tap $(MPI_RESULT) $(FAULT_RESULT) $(PLAIN_RESULT) $(LIBRARY_RESULT) $(OTHER_RESULTS) $(PICTURE_RESULT) $(PRINTED_RESULT) $(SNIPPET_RESULT) $(INSPECT_RESULT) $(BREAK_RESULT) \
           $(TESTS:%=%.tap) $(GOLDEN_RESULTS)

$(patsubst tests/cli/%.c,$(BUILD)/test/%.tap,$(filter tests/cli/%,$(TEST_SOURCES))): $(PROGRAM)
$(TESTS:%=%.tap): %.tap: % always
	$(call say,TEST,$(*F))$(RUN_TEST) $@ $*
$(GOLDEN_RESULTS): $(GOLDEN_TEST) always
	$(call say,TEST,$(@F:.tap=))GP_ISA=$(patsubst golden.%.tap,%,$(@F)) $(RUN_TEST) $@ $<

$(PICTURE_RESULT): $(PROGRAM) always
	$(call say,TEST,$(@F:.tap=))$(RUN_TEST) $@ sh tests/tools/golden_pictures.sh $<

# Where there is MPI; else it says "skipped".
HAS_MPI := $(shell command -v $(MPICC) >/dev/null && command -v $(MPIRUN) >/dev/null && echo 1)
$(BUILD)/test/mpi.tap: $(PROGRAM) $(if $(HAS_MPI),$(MPI_PROGRAM)) always
	$(call say,TEST,$(@F:.tap=))MPIRUN='$(MPIRUN)' $(RUN_TEST) $@ sh tests/tools/mpi.sh $< \
	    $(if $(HAS_MPI),$(MPI_PROGRAM))

$(BUILD)/test/inspect.tap: $(PROGRAM) always
	$(call say,TEST,$(@F:.tap=))$(RUN_TEST) $@ sh tests/tools/inspect_pages.sh $<

$(BUILD)/test/lessons.tap: $(PROGRAM) always
	$(call say,TEST,$(@F:.tap=))$(RUN_TEST) $@ sh tests/tools/inspect_pages.sh $< lessons

$(BUILD)/test/break_it.tap: $(PROGRAM) $(BREAKS) always
	$(call say,TEST,$(@F:.tap=))$(RUN_TEST) $@ sh tests/tools/break_it.sh test $< $(BUILD)/break

# Installed first, since what is printed must run there too.
TRIED := $(abspath $(BUILD))/test/installed
$(PRINTED_RESULT): all always
	@mkdir -p $(@D)
	$(call say,TEST,$(@F:.tap=))$(MAKE) --no-print-directory PREFIX=$(TRIED) DESTDIR= install \
	    >$(TRIED).log && $(RUN_TEST) $@ sh tests/tools/printed_commands.sh $(PROGRAM) $(TRIED)

$(BUILD)/test/headers.tap: $(HEADERS) always
	$(call say,TEST,$(@F:.tap=))$(RUN_TEST) $@ sh tests/tools/check_headers.sh $(BUILD)/include \
	    $(CC) $(CXX)

$(BUILD)/test/library.tap: all always
	$(call say,TEST,$(@F:.tap=))CC='$(CC)' CXX='$(CXX)' $(RUN_TEST) $@ sh tests/tools/check_library.sh \
	    $(BUILD) short

$(BUILD)/test/snippets.tap: $(CORE_A) $(HEADERS) always
	$(call say,TEST,$(@F:.tap=))$(RUN_TEST) $@ sh tests/tools/check_snippets.sh $(BUILD)/include $(CORE_A)

# Run here, and emulated inside.
$(OTHER_RESULTS): $(BUILD)/test/as.%.tap: $(PROGRAM) $(GOLDEN_TEST) $(DIFFERENTIAL_TEST) \
                                          $(BUILD)/test/test_widths always
	$(call say,TEST,"as $*")$(RUN_TEST) $@ sh tests/tools/other_processor.sh $* $(BUILD) \
	    $(filter $(WIDTHS:lanes%=%),$(subst $(comma), ,$(patsubst $*:%,%,$(filter $*:%,$(OTHER_PROCESSORS)))))

# The golden frames by the plain twins of all intrinsics, which ARM runs.
PLAIN := $(BUILD)/plain-lanes
$(PLAIN_RESULT): always
	+@mkdir -p $(@D) && $(MAKE) --no-print-directory BUILD=$(PLAIN) OPT=-O1 CXX= ISAS=4:generic: \
	    CPPFLAGS='$(CPPFLAGS) -DGP_PLAIN_LANES' $(PLAIN)/test/golden >$(PLAIN).log 2>&1 || { cat $(PLAIN).log; exit 1; }
	$(call say,TEST,plain_lanes)$(RUN_TEST) $@ $(PLAIN)/test/golden

test: all $(RESULTS)
	@awk -f tests/tools/summary.awk $(RESULTS)

.PHONY: test-golden
# Seeds of random scenes that both executors must draw with the same bits.
SEEDS ?= 0..1999
$(DIFFERENTIAL_TEST).tap: $(DIFFERENTIAL_TEST) always
	$(call say,TEST,differential)$(RUN_TEST) $@ $< $(SEEDS)

.PHONY: differential
differential: $(DIFFERENTIAL_TEST)
	@$(EMULATOR) $< $(SEEDS)

FAULTS  := $(BUILD)/test/faults
FAIL_SO := $(BUILD)/test/libfail_calls.so
$(FAULTS): $(call object,$(filter-out %/fail_calls.c,$(wildcard tests/faults/*.c)))
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(CC) $(LDFLAGS) $^ -o $@
$(FAIL_SO): $(BUILD)/obj/tests/faults/fail_calls.o
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(CC) -shared $(LDFLAGS) $^ -ldl -o $@
# In short, those that once took a failure badly.
$(FAULT_RESULT): $(PROGRAM) $(FAULTS) $(FAIL_SO) always
	$(call say,TEST,$(@F:.tap=))$(RUN_TEST) $@ $(FAULTS) $(PROGRAM) $(FAIL_SO) --most 6 \
	    frames frames-path frames-resume points-file render-dump chart test test-bless
faults: $(PROGRAM) $(FAULTS) $(FAIL_SO)
	@$(FAULTS) $(PROGRAM) $(FAIL_SO) $(if $(MOST),--most $(MOST)) $(if $(KIND),--kind $(KIND)) $(COMMANDS)

# Branches of the pipeline that the tests take, and calls that fail, of a build of its own. What faults says
# there is not asked: keeping counts makes calls, which fail too.
COVERED = $(MAKE) --no-print-directory CC=clang CXX=clang++ BUILD=out/coverage OPT=-O1 COVERAGE=1
.PHONY: coverage
coverage: | packages
	@rm -rf out/coverage/profiles out/coverage/faults && mkdir -p out/coverage/profiles
	+@PROFILES=$(CURDIR)/out/coverage/profiles TEST_SECONDS=1800 $(COVERED) test; failed=$$?; \
	    LLVM_PROFILE_FILE=$(CURDIR)/out/coverage/faults/%m.profraw $(COVERED) faults MOST=1000 \
	        COMMANDS='render sorted render-reference compare points-adaptive voxelize-conservative' >out/coverage/faults.log; \
	    sh tests/tools/coverage.sh out/coverage && exit $$failed

# Operators of the pipeline made wrong, COUNT of them one at a time, in this checkout.
.PHONY: mutants
mutants: | packages
	@python3 tests/tools/mutate.py '$(LOG)' $(or $(COUNT),20) $(or $(SEED),1) $(FILES)

# Readers under libFuzzer and the sanitizers: FUZZ_S seconds for each of TARGETS, or of all.
FUZZER := $(BUILD)/test/fuzz
$(FUZZER): $(BUILD)/obj/tests/fuzz/libfuzzer.o $(FUZZ) $(SUPPORT_A) $(APPS_A) $(SHADERS_A) $(IO_A) $(CORE_A) \
           | $(LOADED)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) -fsanitize=fuzzer $^ -lcmocka $(LIBS) -o $@
.PHONY: fuzz
fuzz:
	+@sh tests/tools/fuzz.sh $(BUILD)/fuzz '$(FUZZ_S)' $(TARGETS)

# One device, random lists, so many seconds: its memory stays, and so do the bits.
SOAK   := $(BUILD)/test/soak
SOAK_S ?= 10
$(SOAK): $(BUILD)/obj/tests/load/soak.o $(SUPPORT_A) $(SHADERS_A) $(CORE_A)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $^ -lm -o $@
.PHONY: soak
soak: $(SOAK)
	@$(SOAK) $(SOAK_S)

# The table of builds, processors, lanes, threads and executors against pictures.
.PHONY: matrix
matrix:
	+@WERROR='$(WERROR)' BUILDS='$(BUILDS)' PROCESSORS='$(PROCESSORS)' PICTURES='$(PICTURES)' \
	    sh tests/tools/matrix.sh $(BUILD)/check

test-golden: $(GOLDEN_RESULTS)
	@awk -f tests/tools/summary.awk $^

# The hash of every scene at every width, for comparing builds.
.PHONY: scene-hashes
scene-hashes: $(foreach width,$(WIDTHS),$(BUILD)/test/$(width).scenes)
$(BUILD)/test/%.scenes: $(PROGRAM) always
	@mkdir -p $(@D)
	$(call say,TEST,$(@F))GP_ISA=$* EMULATOR='$(EMULATOR)' sh tests/tools/scene_hashes.sh $(PROGRAM) >$@

# CASE: a golden frame's name, or the arguments that stand in tests/golden/pictures.txt.
bless: $(GOLDEN_TEST) $(PROGRAM)
	@test -n '$(CASE)' || { echo 'usage: make bless CASE=name' >&2; exit 2; }
	@$(if $(word 2,$(CASE)),sh tests/tools/golden_pictures.sh $(PROGRAM) '$(CASE)', \
	    GP_ISA=lanes4 $(GOLDEN_TEST) --bless '$(CASE)')

format:
	@find pipeline shaders_c apps tests -name '*.[ch]' -o -name '*.[ch]pp' | xargs clang-format -i

# Circles show in the objects, which everything else needs as well.
LINT_OBJECTS = $(CORE) $(IO) $(APPS) $(SHADERS) $(MAIN)
lint: $(LINT_OBJECTS)
	@CC='$(CC)' sh tests/tools/lint.sh $(BUILD) $^

# The public headers as HTML; a function or struct without its comment is an error.
docs: $(HEADERS)
	@sh tests/tools/docs.sh $(BUILD)/include tests/tools/docs.awk out/docs

check: | packages
	+@sh tests/tools/check.sh $(BUILD)

# The peer is loaded when the program runs, which says "skipped" where there is none.
PEER_TEST := $(BUILD)/test/check_peer
PEER      := $(call object,$(wildcard tests/peer/*.c))
$(PEER_TEST): $(PEER) $(SUPPORT_A) $(APPS_A) $(SHADERS_A) $(IO_A) $(CORE_A)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $^ $(LIBS) -o $@

check-peer: $(PEER_TEST)
	@$(PEER_TEST)

# The same work on llvmpipe and here, in turn, case by case: out/bench/peers.json and .svg.
PEER_BENCH         := $(BUILD)/test/peer_bench
PEER_BENCH_OBJECTS := $(call object,$(wildcard tests/peer/bench/*.c) tests/peer/gl.c)
$(PEER_BENCH): $(PEER_BENCH_OBJECTS) $(APPS_A) $(SHADERS_A) $(IO_A) $(CORE_A)
	@mkdir -p $(@D)
	$(call say,LINK,$@)$(LINK) $^ $(LIBS) -o $@

.PHONY: bench-peers
bench-peers: $(PEER_BENCH) $(PROGRAM)
	@sh tests/tools/bench_peers.sh $(PROGRAM) $(PEER_BENCH) out/bench $(CASES)

MESHES ?= $(wildcard ../shared/data/meshes/bunny.ply ../shared/data/meshes/happy_buddha.ply)
.PHONY: bench-commands
bench-commands: $(PROGRAM)
	@python3 tests/tools/bench_commands.py $(PROGRAM) $(or $(MESHES),scenes/models/star.off)

# --- installing -----------------------------------------------------------------------------------

INSTALLED := $(DESTDIR)$(PREFIX)
MAN_PAGES := $(wildcard apps/man/*.[15])
man_place  = man$(subst .,,$(suffix $(1)))/$(notdir $(1))
SHIPPED   := $(wildcard scenes/*.json scenes/models/* scenes/shaders/* scenes/lessons/*.json)
COMPLETION := $(wildcard apps/completion/*)
# What debuggers need, nine tenths of the bytes, is not installed; out/ keeps it.
STRIP := $(shell $(CC) -print-prog-name=strip)

install: all
	install -d $(INSTALLED)/bin $(INSTALLED)/lib
	install -m 755 $(PROGRAM) $(INSTALLED)/bin/
	[ ! -e $(MPI_PROGRAM) ] || install -m 755 $(MPI_PROGRAM) $(INSTALLED)/bin/
	install -m 644 $(CORE_A) $(INSTALLED)/lib/
	install -m 755 $(CORE_SO).$(VERSION) $(LOADED) $(INSTALLED)/lib/
	$(STRIP) $(INSTALLED)/bin/glasspipe $(INSTALLED)/lib/libglasspipe.so.$(VERSION) \
	    $(patsubst $(BUILD)/%,$(INSTALLED)/%,$(LOADED))
	$(STRIP) --strip-debug $(INSTALLED)/lib/libglasspipe.a
	ln -sf libglasspipe.so.$(VERSION) $(INSTALLED)/lib/$(SONAME)
	ln -sf $(SONAME) $(INSTALLED)/lib/libglasspipe.so
	cd $(BUILD) && find include share lib/cmake lib/pkgconfig -type f -exec \
	    install -D -m 644 '{}' $(abspath $(INSTALLED))/'{}' ';'
	$(foreach page,$(MAN_PAGES),install -D -m 644 $(page) \
	    $(INSTALLED)/share/man/$(call man_place,$(page)) &&) true
	for file in $(SHIPPED); do \
	    install -D -m 644 $$file $(INSTALLED)/share/glasspipe/$$file || exit; done
	$(EMULATOR) $(PROGRAM) render --schema >$(INSTALLED)/share/glasspipe/scene.schema.json
	install -D -m 644 GOLDEN_PICTURES.md $(INSTALLED)/share/doc/glasspipe/GOLDEN_PICTURES.md
	install -D -m 644 CLUSTER.md $(INSTALLED)/share/doc/glasspipe/CLUSTER.md
	install -d $(INSTALLED)/share/bash-completion/completions
	$(if $(COMPLETION),install -m 644 $(firstword $(COMPLETION)) \
	    $(INSTALLED)/share/bash-completion/completions/glasspipe)

uninstall:
	rm -rf $(addprefix $(INSTALLED)/,include/glasspipe share/glasspipe share/doc/glasspipe \
	    lib/cmake/glasspipe)
	rm -f $(INSTALLED)/bin/glasspipe $(INSTALLED)/bin/glasspipe-mpi $(INSTALLED)/lib/libglasspipe.* \
	    $(INSTALLED)/lib/libglasspipe_oiio.so $(INSTALLED)/lib/libglasspipe_openmesh.so \
	    $(INSTALLED)/lib/pkgconfig/glasspipe.pc \
	    $(foreach page,$(MAN_PAGES),$(INSTALLED)/share/man/$(call man_place,$(page))) \
	    $(INSTALLED)/share/bash-completion/completions/glasspipe

# --- the rest -------------------------------------------------------------------------------------

clean:
	rm -rf $(addprefix $(BUILD)/,bin lib include share obj test check break)

help:
	@echo 'make             build out/bin/glasspipe and out/lib/libglasspipe.{a,so}'
	@echo 'make run         install what is missing, build, draw scenes/together.json'
	@echo 'make test        install what is missing, build, run every test'
	@echo 'make lint        floors, circles, sizes, format and words of the sources'
	@echo 'make format      clang-format on all of them'
	@echo 'make check       all of that with both compilers, -O0 to -O3, every lane width,'
	@echo '                 sanitizers, aarch64, the exhaustive tests, the machine code, install'
	@echo 'make check-peer  against an independent rasterizer (Mesa through EGL), where there is one'
	@echo 'make differential SEEDS=A..B    random scenes: both executors, the same bits'
	@echo 'make coverage    which branches of the pipeline the tests take (clang, llvm): out/coverage/branches.txt'
	@echo 'make mutants     makes operators wrong, one at a time, and tells what notices; COUNT= SEED= FILES= LOG='
	@echo 'make fuzz        reads anything, under clang and its sanitizers; FUZZ_S= seconds a target, TARGETS=...'
	@echo 'make matrix      a table of builds and processors: the same bits; BUILDS=, PROCESSORS=, PICTURES=N of a command'
	@echo 'make soak        random lists for SOAK_S= seconds: the same bits, and no more memory'
	@echo 'make faults      lets calls of every command fail once; MOST=N of a kind, KIND=, COMMANDS='
	@echo 'make lessons     twelve questions about the pipeline, and eight ways to break it: out/lessons'
	@echo 'make docs        the public headers as HTML in out/docs (doxygen)'
	@echo 'make bench-peers    against llvmpipe in one run, with a chart in out/bench/'
	@echo 'make bench-commands whole commands, from MESHES to pictures, beside VTK and ImageMagick'
	@echo 'make bless CASE=name    take the present picture of a golden case as the right one'
	@echo 'make deps        install the Debian packages that building and testing need'
	@echo 'make mpi         bin/glasspipe-mpi, for mpirun; make deps-mpi installs Open MPI'
	@echo 'make install     PREFIX=/usr/local DESTDIR= ; make uninstall takes it away again'
	@echo 'make clean       remove what was built; pictures in out/ stay'
	@echo
	@echo 'Variables: CC CXX OPT=-O2 SANITIZE=address,undefined WERROR=1 BUILD=out V=1,'
	@echo "and ISAS, the shader variants: '$(ISAS)'"

OBJECTS := $(call object,$(OIIO) $(OPENMESH) $(wildcard tests/faults/*.c tests/fuzz/*.c tests/load/*.c)) $(DIFFERENTIAL) $(PEER_BENCH_OBJECTS) $(CORE) $(IO) $(APPS) $(SUPPORT) $(GOLDEN) $(PEER) $(MAIN) \
           $(foreach v,$(VARIANTS),$(patsubst %.o,%.$(v).o,$(SHADERS) $(TEST_SHADERS))) \
           $(call object,$(TEST_SOURCES) $(wildcard tests/kernel/*.c))
-include $(OBJECTS:.o=.d) $(BREAKS:=.d)
