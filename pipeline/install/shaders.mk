# Shaders for GNU make: of each file in GP_SHADERS one object with its code for every lane width of
# the processor's architecture, so that GP_ISA chooses among them, and with its counting build, which
# knows what it costs.
#
#     GP_SHADERS := triangle.c
#     include $(shell pkg-config --variable=shaders_mk glasspipe)
#     CPPFLAGS += $(GP_CPPFLAGS)
#
#     draw: main.o $(GP_SHADER_OBJECTS)
#     	$(CC) $^ $(GP_LIBS) -o $@
#
# CC, CXX, CPPFLAGS, CFLAGS and CXXFLAGS count as everywhere; without a CXX the costs are not known.
# GP_OBJECTS, "build/", is a folder for the objects; without it they stand beside their sources.
# Both cmake and `glasspipe shader` read the lines GP_ISAS_..., GP_MODEL and GP_GCC_OPT of this file.

# The bits depend on these: no contraction into fused multiply-adds, and sqrt as one instruction.
GP_MODEL := -ffp-contract=off -fno-math-errno

# Each shader is compiled once for every instruction set: lanes:name:flags. (Fused multiply-adds stand
# where the lanes name them; contraction is off.)
GP_ISAS_x86_64 := 4:sse2: 8:avx2:-mavx2,-mf16c,-mfma 16:avx512:-mf16c,-mavx512f,-mavx512vl,-mavx512dq,-mavx512bw
# ARM has registers of four lanes: eight are pairs of them, sixteen would only spill.
GP_ISAS_aarch64 := 4:neon: 8:generic:
GP_ISAS_generic := 4:generic: 8:generic: 16:generic:
GP_ARCH ?= $(shell uname -m)
GP_ISAS ?= $(or $(GP_ISAS_$(GP_ARCH)),$(GP_ISAS_generic))

# gcc puts a value that is used once where it is used: chains that could run side by side come one after the
# other, and wait (alu_flat takes half the time without, and long shaders spill 7 % less).
GP_GCC_OPT := -fno-tree-ter
GP_IS_CLANG := $(shell $(CC) --version | grep -i clang)
GP_SHADER_OPT ?= $(if $(GP_IS_CLANG),,$(GP_GCC_OPT))

# This file is PREFIX/share/glasspipe/shaders.mk.
GP_PREFIX := $(abspath $(dir $(lastword $(MAKEFILE_LIST)))../..)
GP_CPPFLAGS ?= -I$(GP_PREFIX)/include
GP_LIBS ?= -L$(GP_PREFIX)/lib -Wl,-rpath,$(GP_PREFIX)/lib -lglasspipe -lm

GP_COMPILE ?= $(CC) -O2 -fPIC $(CPPFLAGS) $(GP_CPPFLAGS) $(CFLAGS) $(GP_MODEL) -MMD -MP
# Shaders may share structs by headers; the counting lanes inside them are each object's own.
GP_COMPILE_COUNT ?= $(CXX) -O1 -fPIC $(CPPFLAGS) $(GP_CPPFLAGS) $(CXXFLAGS) -std=gnu++20 -fno-exceptions -MMD -MP \
            $(if $(GP_IS_CLANG),,-Wno-subobject-linkage) -x c++

# --- rules: the variants refer to each other weakly, so any subset works --------------------------

gp_goal := $(.DEFAULT_GOAL)
gp_comma := ,
gp_part = $(subst $(gp_comma), ,$(word $(1),$(subst :, ,$(2))))

define gp_variant
$(GP_OBJECTS)%.lanes$(call gp_part,1,$(1)).o: %.c $(GP_NEEDS)
	@mkdir -p $$(@D)
	$$(call GP_SAY,CC,"$$< ($(call gp_part,2,$(1)) $(call gp_part,1,$(1)))")$$(GP_COMPILE) \
	    -DGP_LANES=$(call gp_part,1,$(1)) '-DGP_ISA_NAME="$(call gp_part,2,$(1))"' \
	    $(call gp_part,3,$(1)) $$(GP_SHADER_OPT) -c $$< -o $$@
endef
$(foreach isa,$(GP_ISAS),$(eval $(call gp_variant,$(isa))))

$(GP_OBJECTS)%.count.o: %.c $(GP_NEEDS)
	@mkdir -p $(@D)
	$(call GP_SAY,CXX,"$< (counting)")$(GP_COMPILE_COUNT) -c $< -o $@

GP_VARIANTS := $(foreach isa,$(GP_ISAS),lanes$(call gp_part,1,$(isa))) $(if $(CXX),count)
GP_SHADER_OBJECTS := $(patsubst %.c,$(GP_OBJECTS)%.o,$(GP_SHADERS))
$(GP_SHADER_OBJECTS): %.o: $(foreach variant,$(GP_VARIANTS),%.$(variant).o)
	@$(CC) -r -nostdlib $^ -o $@

-include $(foreach variant,$(GP_VARIANTS),$(GP_SHADER_OBJECTS:.o=.$(variant).d))
.SECONDARY: $(foreach variant,$(GP_VARIANTS),$(GP_SHADER_OBJECTS:.o=.$(variant).o))
.DEFAULT_GOAL := $(gp_goal)
