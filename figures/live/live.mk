# live.mk - live figures: figures/live/NAME.c as a program of this machine, whose
# hash tests/bits/bits.txt keeps, and as WebAssembly that runs in the page.

# A figure, and the chapter up to which it sees the library.
define LIVES
01/orbit
09/room
endef
# What a figure takes from other folders, beside the library.
WITH_room := figures/runner.o tests/poses.o
LIVE := $(notdir $(strip $(LIVES)))
LIVE_PROGRAMS := $(LIVE:%=$(BUILD)/live/%)
live_chapter = $(patsubst %/$1,%,$(filter %/$1,$(strip $(LIVES))))
live_floor   = $(call FLOOR,$(call live_chapter,$1))

# --- On this machine ------------------------------------------------------------
$(BUILD)/live/%.o: figures/live/%.c $(BUILD)/flags
	$(compile)
$(LIVE_PROGRAMS): $(BUILD)/live/%: $(BUILD)/live/%.o $(BUILD)/live/live.o \
  $(BUILD)/live/live_main.o $$(addprefix $(BUILD)/,$$(WITH_$$*)) $$(call live_floor,$$*)
	$(call link,-lm)
.PHONY: live-programs
live-programs: $(LIVE_PROGRAMS)
$(BUILD)/live/%.json: $(BUILD)/live/%
	$(Q)$< --panel > $@

# --- In the browser -------------------------------------------------------------
# The default stack of 64 kB is too small for some scenes, and where it ends
# other data would begin: --stack-first makes of an overflow an error.
WASM_CC   ?= clang
WASM      := $(WASM_CC) --target=wasm32-wasi --sysroot=/usr
WASM_C     = $(WASM) $(EXACT) -O3 -msimd128 -Wall -Wextra $(ROOMS) -MMD -MP
WASM_LINK := -nostartfiles -Wl,--no-entry,--strip-debug,--gc-sections,--stack-first,-z,stack-size=1048576
$(BUILD)/wasm/flags: FORCE
	$(Q)mkdir -p $(@D)
	$(Q)echo '$(strip $(WASM_C))' | cmp -s - $@ || echo '$(strip $(WASM_C))' > $@
define wasm
	@mkdir -p $(@D)
	@echo "  wasm  $<"
	$(Q)$(WASM_C) $1 -c $< -o $@
endef
$(BUILD)/wasm/lib/%.o: $$(or $$(wildcard lib/*/$$*.c),lib/*/$$*.c) $(BUILD)/wasm/flags
	$(call wasm)
$(BUILD)/wasm/figures/%.o: $$(or $$(wildcard figures/*/$$*.c),figures/*/$$*.c) $(BUILD)/wasm/flags
	$(call wasm)
$(BUILD)/wasm/tests/%.o: $$(or $$(wildcard tests/*/$$*.c),tests/*/$$*.c) $(BUILD)/wasm/flags
	$(call wasm)
$(BUILD)/wasm/live/%.o: figures/live/%.c $(BUILD)/wasm/flags
	$(call wasm)
$(LIVE:%=$(BUILD)/wasm/%.wasm): $(BUILD)/wasm/%.wasm: $(BUILD)/wasm/live/%.o \
  $(BUILD)/wasm/live/live.o $(BUILD)/wasm/live/live_wasm.o $$(addprefix $(BUILD)/wasm/,$$(WITH_$$*)) \
  $$(subst $(BUILD)/lib/,$(BUILD)/wasm/lib/,$$(call live_floor,$$*))
	@echo "  link  $@"
	$(Q)$(WASM) $(WASM_LINK) $^ -o $@
-include $(wildcard $(BUILD)/wasm/*/*.d $(BUILD)/live/*.d)

# A plain script, since file:// lets no other in.
$(LIVE:%=$(BUILD)/live/%.js): $(BUILD)/live/%.js: $(BUILD)/wasm/%.wasm
	$(Q){ printf 'tumble.wasm["$*"]="'; gzip -9nc $< | base64 | tr -d '\n'; echo '";'; } > $@

# --- The page's side --------------------------------------------------------------
# npm puts what package.json names into build/, not beside the sources.
$(BUILD)/node/.done: figures/live/package.json figures/live/package-lock.json
	$(Q)mkdir -p $(@D) && cp $^ figures/live/.npmrc $(@D)
	$(Q)cd $(@D) && npm ci --no-fund --no-audit --silent && touch .done
BUNDLE = NODE_PATH=$(BUILD)/node/node_modules $(BUILD)/node/node_modules/.bin/esbuild \
  --bundle --minify --format=iife --loader:.css=text --legal-comments=none --log-level=warning
LIVE_JS := $(wildcard figures/live/*.js figures/live/*.css)
$(BUILD)/live/main.js $(BUILD)/live/space.js: $(BUILD)/live/%.js: $(LIVE_JS) $(BUILD)/node/.done
	$(Q)mkdir -p $(@D)
	$(Q)$(BUNDLE) figures/live/$*.js --outfile=$@
# What the panels of all figures hold, and the bundle.
$(BUILD)/live/live.js: $(LIVE:%=$(BUILD)/live/%.json) $(BUILD)/live/main.js
	$(Q){ echo 'window.tumble={wasm:{},panels:{'; \
	  for f in $(LIVE); do printf '%s:' $$f; cat $(BUILD)/live/$$f.json; echo ','; done; echo '}};'; \
	  cat $(BUILD)/live/main.js; } > $@

# All that a page needs, to be copied beside it into live/.
LIVE_FILES := $(BUILD)/live/live.js $(BUILD)/live/space.js $(LIVE:%=$(BUILD)/live/%.js)
.PHONY: live-files
live-files: $(LIVE_FILES)

# --- Stills -----------------------------------------------------------------------
# Those of a chapter's figures alone are on its page.
.PHONY: $(LIVE:%=still-%)
$(LIVE:%=still-%): still-%: $(BUILD)/live/%.js $(BUILD)/live/live.js $(BUILD)/live/space.js
	$(Q)sh figures/live/page.sh $(call live_chapter,$*) $(BUILD)/live $*
	$(Q)cp figures/live/still.js $(BUILD)/node/ && node $(BUILD)/node/still.js \
	  $(abspath $(BUILD))/live/$(call live_chapter,$*).html $* $(BUILD)/live/$*.png
	$(Q)cwebp -quiet -q 82 -m 6 -resize 1200 0 $(BUILD)/live/$*.png -o figures/live/$*.webp
	@ls -l figures/live/$*.webp
