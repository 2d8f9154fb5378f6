# live.mk - live figures: figures/live/NAME.c as a program of this machine, whose
# hash tests/bits/bits.txt keeps, and as WebAssembly that runs in the page.

# A figure, and the chapter up to which it sees the library.
define LIVES
00/bounce
00/dot
00/leap
00b/carts
00b/swing
00b/spin
00b/crate
01/orbit
02/rope
02/phase
02/walk
03/cube
04/gjk
04/support
04/regions
05/epa
05/climb
06/tree
06/enclose
06/descend
07/shares
07/cone
08/blow
08/ruler
08/fade
09/room
09/drape
10/nearest
10/tin
11/slab
11/clip
11/keep
12/strand
12/thomas
12/bend
13/four
13/pile
13/carry
13/top
13/relax
13/sag
14/crowd
14/prune
14/margin
15/bullet
15/nearing
15/needle
16/fabric
16/shadow
17/chain
17/front
18/energy
18/island
18/canopy
19/topple
19/ray
19/sandbox
20/hard
21/work
24/halves
endef
# What a figure takes from other folders, beside the library.
WITH_gjk := rules/04-distance-1.o live/plane.o
$(foreach f,dot epa climb shares nearest slab regions clip keep shadow tin needle,$(eval WITH_$f := live/plane.o))
WITH_carry := tests/plain_solver.o
WITH_relax := tests/plain_solver.o
WITH_sag := tests/plain_solver.o
WITH_hard := live/live_world.o live/view.o tests/hard_set.o tests/hard_drape_set.o tests/experiments.o
WITH_sandbox := live/view.o $(SCENES:%.c=figures/%.o)
$(foreach f,drape room,$(eval WITH_$f := figures/runner.o tests/poses.o tests/experiments.o))
$(foreach f,pile fabric chain energy canopy island,$(eval WITH_$f := live/live_world.o))
# The first program of the book runs on a module of the next chapter, and what turns in
# a plane is linked with chapter 04.
FLOOR_bounce := 01
FLOOR_dot := 04

LIVE := $(notdir $(strip $(LIVES)))
LIVE_PROGRAMS := $(LIVE:%=$(BUILD)/live/%)
live_chapter = $(patsubst %/$1,%,$(filter %/$1,$(strip $(LIVES))))
live_floor   = $(call FLOOR,$(or $(FLOOR_$1),$(call live_chapter,$1)))

# --- On this machine ------------------------------------------------------------
$(BUILD)/live/%.o: figures/live/%.c $(BUILD)/flags
	$(compile)
$(LIVE_PROGRAMS): $(BUILD)/live/%: $(BUILD)/live/%.o $(BUILD)/live/live.o $(BUILD)/live/live_soft.o \
  $(BUILD)/live/live_main.o $(BUILD)/live/live_film.o $$(addprefix $(BUILD)/,$$(WITH_$$*)) $$(call live_floor,$$*)
	$(call link,-lm)
.PHONY: live-programs
live-programs: $(LIVE_PROGRAMS)

# --- In the browser -------------------------------------------------------------
# The default stack of 64 kB is too small for some scenes, and where it ends
# other data would begin: --stack-first makes of an overflow an error.
WASM_CC   ?= clang
WASM      := $(WASM_CC) --target=wasm32-wasi --sysroot=/usr
# Clang 14 pairs scalars wrongly there: of joint.c it made rows that lost a doll's numbers.
WASM_C     = $(WASM) $(EXACT) -O3 -msimd128 -fno-slp-vectorize -Wall -Wextra $(ROOMS) -MMD -MP
WASM_LINK := -nostartfiles -Wl,--no-entry,--strip-debug,--gc-sections,--stack-first,-z,stack-size=1048576
$(OURS)/wasm/flags: FORCE
	$(Q)mkdir -p $(@D)
	$(Q)echo '$(strip $(WASM_C))' | cmp -s - $@ || echo '$(strip $(WASM_C))' > $@
define wasm
	@mkdir -p $(@D)
	@echo "  wasm  $<"
	$(Q)$(WASM_C) $1 -c $< -o $@
endef
$(OURS)/wasm/lib/%.o: $$(or $$(wildcard lib/*/$$*.c),lib/*/$$*.c) $(OURS)/wasm/flags
	$(call wasm)
$(OURS)/wasm/figures/%.o: $$(or $$(wildcard figures/*/$$*.c),figures/*/$$*.c) $(OURS)/wasm/flags
	$(call wasm)
$(OURS)/wasm/tests/%.o: $$(or $$(wildcard tests/*/$$*.c),tests/*/$$*.c) $(OURS)/wasm/flags
	$(call wasm)
$(OURS)/wasm/rules/04-distance-%.o: $(OURS)/rules/04-distance-%.c $(OURS)/wasm/flags
	$(call wasm,$(foreach f,$(GJK_NAMES),-D$f=$f_$*))
$(OURS)/wasm/live/%.o: figures/live/%.c $(OURS)/wasm/flags
	$(call wasm)
# The reader's own counts the turns of its loops, so that one without end is
# stopped, and not taken for a loop with an end.
COUNTED := -Wno-unused -Wno-unused-parameter -fsanitize-coverage=trace-pc,edge,no-prune -fno-finite-loops
define wasm_swap
$(BUILD)/wasm/mine/$(notdir $(1:.c=.o)): $1 $(BUILD)/flags $(BUILD)/mine
	$$(call wasm,$$(COUNTED)) || { echo "$1: does not compile; begin with the first error\
	 above" >&2; exit 1; }
endef
$(foreach f,$(MINE),$(eval $(call wasm_swap,$f)))
WASM_MINE := $(addprefix $(BUILD)/wasm/mine/,$(notdir $(MINE:.c=.o)))
live_objects = $(filter-out $(WASM_MINE:$(BUILD)/wasm/mine/%=$(OURS)/wasm/lib/%),\
  $(subst $(BUILD)/lib/,$(OURS)/wasm/lib/,$(call live_floor,$1))) $(WASM_MINE)
$(LIVE:%=$(BUILD)/wasm/%.wasm): $(BUILD)/wasm/%.wasm: $(OURS)/wasm/live/%.o \
  $(OURS)/wasm/live/live.o $(OURS)/wasm/live/live_soft.o $(OURS)/wasm/live/live_wasm.o \
  $$(addprefix $(OURS)/wasm/,$$(WITH_$$*)) $$(call live_objects,$$*)
	@echo "  link  $@"
	$(Q)$(WASM) $(WASM_LINK) $^ -o $@
$(OURS)/wasm/%.d: ;
-include $(wildcard $(OURS)/wasm/*/*.d)

# What the page builds before the figure itself is there: dials, charts, hashes.  A
# program that only tells of the figure needs nothing of the library; the lines that
# it reads of it are newer when the figure is.
$(LIVE:%=$(OURS)/wasm/%-panel.wasm): %-panel.wasm: $(OURS)/wasm/live/$$(notdir $$*).o $(OURS)/wasm/live/live_panel.o
	$(Q)$(WASM) -Wl,--unresolved-symbols=ignore-all,--gc-sections $^ -o $@
ifeq ($(OURS),$(BUILD))
$(LIVE:%=$(OURS)/live/%.json): $(OURS)/live/%.json: $(OURS)/wasm/%-panel.wasm $(OURS)/wasm/%.wasm tests/bits/bits.txt figures/live/panel.mjs
	$(Q)mkdir -p $(@D)
	$(Q)node --no-warnings figures/live/panel.mjs $< tests/bits/bits.txt $@
else
$(OURS)/live/%.json: FORCE
	$(Q)$(AGAIN) -s MINE= BUILD=$(OURS) $@
endif

# A plain script, since file:// lets no other in.
$(LIVE:%=$(BUILD)/live/%.js): $(BUILD)/live/%.js: $(BUILD)/wasm/%.wasm
	$(Q)mkdir -p $(@D)
	$(Q){ printf 'tumble.wasm["$*"]="'; gzip -9nc $< | base64 | tr -d '\n'; echo '";'; } > $@

# --- The page's side --------------------------------------------------------------
# npm puts what package.json names into build/, not beside the sources.
NODE := $(OURS)/node
$(NODE)/.done: figures/live/package.json figures/live/package-lock.json
	$(Q)mkdir -p $(@D) && cp $^ figures/live/.npmrc $(@D)
	$(Q)cd $(@D) && npm ci --no-fund --no-audit --silent && touch .done
BUNDLE = NODE_PATH=$(NODE)/node_modules $(NODE)/node_modules/.bin/esbuild \
  --bundle --minify --format=iife --loader:.css=text --legal-comments=none --log-level=warning
$(OURS)/live/main.js $(OURS)/live/space.js: $(OURS)/live/%.js: $(wildcard figures/live/*.js figures/live/*.css) $(NODE)/.done
	$(Q)mkdir -p $(@D)
	$(Q)$(BUNDLE) figures/live/$*.js --outfile=$@
# What the panels of all figures hold, and the bundle.
$(BUILD)/live/live.js: $(LIVE:%=$(BUILD)/live/%.json) $(BUILD)/live/main.js figures/live/live.mk
	$(Q){ echo '(window.tumble||={}).panels={'; \
	  for f in $(LIVE); do printf '%s:' $$f; cat $(BUILD)/live/$$f.json; echo ','; done; echo '};'; \
	  cat $(BUILD)/live/main.js; } > $@

# All that a page needs, to be copied beside it into live/.
LIVE_FILES := $(BUILD)/live/live.js $(BUILD)/live/space.js $(LIVE:%=$(BUILD)/live/%.js)
.PHONY: live-files
live-files: $(LIVE_FILES)

# --- make live ----------------------------------------------------------------------
# The chapter that is named, or that of the reader's first module.
LIVE_CHAPTER := $(firstword $(NAMED) $(foreach f,$(MINE),$(patsubst %/,%,$(dir $(filter %/$(basename $(notdir $f)),$(LINE))))))
LIVE_SHOWN   := $(notdir $(filter $(LIVE_CHAPTER)/%,$(strip $(LIVES))))
LIVE_TOOLS    = echo 'int main(void) { return 0; }' | $(WASM) -x c - -o /dev/null 2> /dev/null && command -v npm > /dev/null
# An exercise that builds a module: what the reader wrote takes its place.
LIVE_EXERCISE := $(firstword $(foreach goal,$(MAKECMDGOALS),$(if $(findstring /,$(goal)),$(goal))))
.PHONY: live live-page live-film
ifneq ($(LIVE_EXERCISE),)
live:
	@file=$$(sh figures/live/exercise.sh $(LIVE_EXERCISE) $(BUILD)/live/mine) && \
	  $(AGAIN) live $(firstword $(subst /, ,$(LIVE_EXERCISE))) MINE=$$file
else
live:
	@[ -n '$(LIVE_SHOWN)' ] || { echo "make live wants a chapter that has live figures:\
	  $(sort $(patsubst %/,%,$(dir $(strip $(LIVES)))))" >&2; exit 1; }
	@if $(LIVE_TOOLS); then $(AGAIN) live-page NAMED=$(LIVE_CHAPTER) && \
	  sh figures/live/open.sh $(BUILD)/live/$(LIVE_CHAPTER)/index.html; else \
	  echo "A live page needs clang for WebAssembly and npm: make deps-site installs them. Here are films instead." && \
	  $(AGAIN) live-film NAMED=$(LIVE_CHAPTER) && sh figures/live/open.sh $(BUILD)/live/$(LIVE_CHAPTER)/index.html; fi
endif
live-film: $(LIVE_SHOWN:%=$(BUILD)/live/%)
	$(Q)sh figures/live/page.sh $(LIVE_CHAPTER) $(BUILD)/live/$(LIVE_CHAPTER) film $(BUILD)/live $(LIVE_SHOWN)
live-page: $(LIVE_SHOWN:%=$(OURS)/live/%.json) $(LIVE_SHOWN:%=$(BUILD)/live/%.js) $(OURS)/live/main.js $(OURS)/live/space.js
	$(Q)sh figures/live/page.sh $(LIVE_CHAPTER) $(BUILD)/live/$(LIVE_CHAPTER) $(OURS)/live $(BUILD)/live $(LIVE_SHOWN)

# --- Stills -----------------------------------------------------------------------
.PHONY: $(LIVE:%=still-%)
$(LIVE:%=still-%): still-%: need-browser $(BUILD)/live/%.js $(BUILD)/live/%.json $(BUILD)/live/main.js $(BUILD)/live/space.js
	$(Q)sh figures/live/page.sh $(call live_chapter,$*) $(BUILD)/live/still-$* $(BUILD)/live $(BUILD)/live $*
	$(Q)cp figures/live/still.js $(NODE)/ && node $(NODE)/still.js \
	  $(abspath $(BUILD)/live/still-$*/index.html) $* $(BUILD)/live/$*.png
	$(Q)for one in $* $*-dark; do [ ! -e $(BUILD)/live/$$one.png ] || \
	  cwebp -quiet -q 82 -m 6 -resize 1200 0 $(BUILD)/live/$$one.png -o figures/live/$$one.webp; done
	@ls -l figures/live/$*.webp $(wildcard figures/live/$*-dark.webp)
