# workshop.mk - the workshop: the reader's own C, compiled and judged in the page.
# The compiler comes from npm, into build/; where it cannot, the site is made without.

WORKSHOP := $(BUILD)/workshop
# The chapters whose exercises are judged in the page.
WRITTEN := $(filter 0%,$(CHAPTERS))
WORKED := $(sort $(foreach c,$(WRITTEN),$(patsubst exercises/%/exercise,%,$(wildcard exercises/$c-*/exercise))))
exercise_name = $(subst $() $(),/,$(wordlist 1,2,$(subst -, ,$1)))

# Check's own header says what is asserted, and in which words.
CHECK_HEADER = $(shell $(CC) -E -include check.h -x c /dev/null 2> /dev/null | sed -n 's/^. 1 "\(.*\)check\.h".*/\1/p')
$(WORKSHOP)/include/check.h:
	@mkdir -p $(@D)
	$(Q)cp $(CHECK_HEADER)check.h $(CHECK_HEADER)check_stdint.h $(@D)

JUDGED := $(WASM) $(EXACT) -O2 -gline-tables-only -gdwarf-4 -msimd128 -w -Iexercises -I$(WORKSHOP)/include $(ROOMS) -MMD -MP
# The sanitizers of the desk.
WATCHED := -Xclang -fsanitize=address -Xclang -fsanitize-address-use-after-return=never \
  -mllvm -asan-instrumentation-with-call-threshold=0 -mllvm -asan-mapping-offset=268435456
TESTED := -fno-inline -include exercises/judge.h -Dmain=judge_main \
  -fsanitize-coverage=trace-pc,edge,no-prune -fno-finite-loops
$(WORKSHOP)/flags: FORCE
	$(Q)mkdir -p $(@D)
	$(Q)echo '$(JUDGED) $(TESTED) $(WATCHED)' | cmp -s - $@ || echo '$(JUDGED) $(TESTED) $(WATCHED)' > $@
define judged
	@mkdir -p $(@D)
	@echo "  wasm  $<"
	$(Q)$(JUDGED) $1 -c $< -o $@
endef
$(WORKSHOP)/tests/%.o: $$(or $$(wildcard tests/*/$$*.c),tests/*/$$*.c) $(WORKSHOP)/flags $(WORKSHOP)/include/check.h
	$(call judged,$(TESTED) $(WATCHED))
# A long double is computed by software there, 100 times slower: the oracle has
# doubles, which are exact enough for what is asked of it.
$(WORKSHOP)/oracle.c: tests/support/oracle.c
	$(Q)mkdir -p $(@D) && sed 's/^typedef long double wide;/typedef double wide;/' $< > $@
$(WORKSHOP)/tests/oracle.o: $(WORKSHOP)/oracle.c $(WORKSHOP)/flags
	@mkdir -p $(@D)
	@echo "  wasm  $<"
	$(Q)$(WASM) $(EXACT) -O3 -msimd128 $(ROOMS) -c $< -o $@
$(WORKSHOP)/exercises/%/check.o: exercises/%/check.c $(WORKSHOP)/flags $(WORKSHOP)/include/check.h
	$(call judged,$(TESTED) $(WATCHED))
$(WORKSHOP)/exercises/%/solution.o: exercises/%/solution.c $(WORKSHOP)/flags
	$(call judged)
$(WORKSHOP)/judge_page.o: figures/workshop/judge_page.c $(WORKSHOP)/flags $(WORKSHOP)/include/check.h
	$(call judged,-fno-builtin -O3 -finline-functions)
-include $(wildcard $(WORKSHOP)/*.d $(WORKSHOP)/*/*.d $(WORKSHOP)/exercises/*/*.d)

# What each is linked of.
$(WORKSHOP)/parts.mk: figures/workshop/parts.sh exercises/judge.sh Makefile $(WORKED:%=exercises/%/exercise)
	@mkdir -p $(@D)
	$(Q)BUILD='$(BUILD)' sh figures/workshop/parts.sh $(WORKSHOP) $(OURS) $(foreach e,$(WORKED),$(call exercise_name,$e)) > $@.new && mv $@.new $@
ifneq ($(filter site% test-site workshop%,$(MAKECMDGOALS)),)
include $(WORKSHOP)/parts.mk
endif

$(WORKED:%=$(WORKSHOP)/%.o): $(WORKSHOP)/%.o: figures/workshop/workshop.mk
	@echo "  link  $@"
	$(Q)wasm-ld -r $(filter %.o,$^) -o $@
$(WORKED:%=$(WORKSHOP)/%.js): $(WORKSHOP)/%.js: figures/workshop/pack.mjs exercises/cut.awk
	@echo "  pack  $@"
	$(Q)node figures/workshop/pack.mjs exercise $* $(WORKSHOP)/$*.o $(ANSWER_$*) $(SOURCE_$*) > $@
$(WORKED:%=$(WORKSHOP)/%-judged.js): $(WORKSHOP)/%-judged.js: $(WORKSHOP)/%.js ;

# --- What a reader's module moves in ------------------------------------------------
FIGURED := $(foreach e,$(WORKED),$(if $(FIGURE_$e),$e))
figured = $(firstword $(FIGURE_$1))
define figured_rule
$(WORKSHOP)/figure-$1.js: $(addprefix $(OURS)/wasm/,live/$(call figured,$1).o live/live.o live/live_soft.o live/live_wasm.o $(WITH_$(call figured,$1))) \
  $(filter-out $(OURS)/wasm/lib/$(lastword $(FIGURE_$1)).o,$(subst $(OURS)/lib/,$(OURS)/wasm/lib/,$(call live_floor,$(call figured,$1))))
	@echo "  pack  $$@"
	$$(Q)node figures/workshop/pack.mjs figure $(call figured,$1) $$^ > $$@
endef
$(foreach e,$(FIGURED),$(eval $(call figured_rule,$e)))

# --- The little program ---------------------------------------------------------------
# What each stage prints, and the hash of its bits, are those of printed.txt; a stage
# that has changed since is run.
STAGED := $(STAGES:%=$(WORKSHOP)/stage-%.js)
$(WORKSHOP)/printed.txt: $(wildcard chapters/little/*) figures/workshop/printed.c
	$(Q)mkdir -p $(@D) && CC='$(CC)' BUILD='$(BUILD)' sh chapters/little/little.sh printed > $@.new && mv $@.new $@
$(WORKSHOP)/stages.done: $(WORKSHOP)/printed.txt figures/workshop/pack.mjs
	$(Q)node figures/workshop/pack.mjs stages $< $(BUILD)/little/stage $(WORKSHOP)/stage && touch $@
$(STAGED): $(WORKSHOP)/stages.done ;
$(WORKSHOP)/printed.o: figures/workshop/printed.c $(WORKSHOP)/flags
	$(Q)$(WASM) $(EXACT) -O2 -c $< -o $@
$(WORKSHOP)/runner.js: $(WORKSHOP)/printed.o figures/workshop/pack.mjs
	$(Q)node figures/workshop/pack.mjs data $< > $@

# --- The page's side ----------------------------------------------------------------
WORK := $(WORKSHOP)/node
$(WORK)/.done: figures/workshop/package.json figures/workshop/package-lock.json
	$(Q)mkdir -p $(@D) && cp $^ figures/workshop/.npmrc $(@D)
	$(Q)cd $(@D) && npm ci --no-fund --no-audit --silent && touch .done
.PHONY: workshop-tools
workshop-tools:
	@$(AGAIN) -s $(WORK)/.done > /dev/null 2>&1 || echo "The compiler for the page could not be fetched from npm:\
	 is there a network?  The site is made without the workshop: its exercises are read there, and written at the desk." >&2
	$(Q)mkdir -p $(WORKSHOP) && ls $(WORK)/.done 2> /dev/null | cmp -s - $(WORKSHOP)/with || ls $(WORK)/.done > $(WORKSHOP)/with 2> /dev/null || :
$(WORKSHOP)/with: ;

WORK_BUNDLE = NODE_PATH=$(WORK)/node_modules $(NODE)/node_modules/.bin/esbuild \
  --bundle --minify --format=iife --loader:.css=text --legal-comments=none --log-level=error
WORK_JS := $(wildcard figures/workshop/*.js figures/workshop/*.css) $(WORK)/.done $(NODE)/.done
$(WORKSHOP)/editor.js: figures/workshop/editor.js $(WORK)/.done $(NODE)/.done
	$(Q)$(WORK_BUNDLE) $< --outfile=$@
$(WORKSHOP)/clang.js: figures/workshop/faster.awk $(WORK)/.done
	$(Q)awk -f $< $(WORK)/node_modules/@yowasp/clang/gen/bundle.js > $@
$(WORKSHOP)/worker-plain.js: $(WORK_JS) $(WORKSHOP)/clang.js
	$(Q)$(WORK_BUNDLE) --alias:@yowasp/clang=$(abspath $(WORKSHOP)/clang.js) --external:node:fs/promises --define:import.meta.url='"https://workshop/"' figures/workshop/worker.js --outfile=$@
$(WORKSHOP)/worker.js: $(WORKSHOP)/worker-plain.js figures/workshop/pack.mjs
	$(Q)node figures/workshop/pack.mjs worker $< > $@
$(WORKSHOP)/player.js: $(WORK_JS)
	$(Q)$(WORK_BUNDLE) figures/workshop/player.js --outfile=$(WORKSHOP)/player-plain.js
	$(Q)node -p '"tumble.workshop.player=" + JSON.stringify(require("fs").readFileSync("$(WORKSHOP)/player-plain.js", "utf8")) + ";"' > $@
# The compiler in pieces, and where each of its files is in them.
$(WORKSHOP)/compiler.js: figures/workshop/pack.mjs $(WORK)/.done
	@echo "  pack  $@"
	$(Q)rm -f $(WORKSHOP)/clang-*.js && node figures/workshop/pack.mjs compiler $(WORK)/node_modules/@yowasp/clang/gen $(WORKSHOP) > $@
$(WORKSHOP)/workshop.js: $(WORK_JS) $(WORKSHOP)/compiler.js
	$(Q)$(WORK_BUNDLE) figures/workshop/main.js --outfile=$(WORKSHOP)/main.js
	$(Q){ echo '(window.tumble||={}).workshop||={};'; cat $(WORKSHOP)/compiler.js $(WORKSHOP)/main.js; } > $@
$(WORKSHOP)/judge.js: $(WORKSHOP)/judge_page.o figures/workshop/pack.mjs
	$(Q)node figures/workshop/pack.mjs data $< > $@
$(WORKSHOP)/headers.js: $(wildcard lib/*.h lib/*/*.h) figures/workshop/pack.mjs
	$(Q)node figures/workshop/pack.mjs headers $(filter %.h,$^) > $@
$(WORKSHOP)/pairs-all.js: tests/data/pairs-all.txt figures/workshop/pack.mjs
	$(Q)node figures/workshop/pack.mjs data $< > $@

# All that a page needs, to be copied beside it into workshop/; the compiler's pieces
# are counted when they are there.
WORKSHOP_FILES := $(addprefix $(WORKSHOP)/,workshop.js editor.js worker.js player.js headers.js judge.js runner.js pairs-all.js $(STAGES:%=stage-%.js) $(WORKED:%=%.js) $(WORKED:%=%-judged.js) $(FIGURED:%=figure-%.js))
.PHONY: workshop-files
workshop-files: $(WORKSHOP_FILES)
