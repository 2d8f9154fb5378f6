# workshop.mk - the workshop: the reader's own C, compiled and judged in the page.

WORKSHOP := $(BUILD)/workshop
# The chapters whose exercises are judged in the page.
WRITTEN := $(filter 0%,$(CHAPTERS))
EXERCISES := $(sort $(foreach c,$(WRITTEN),$(patsubst exercises/%/exercise,%,$(wildcard exercises/$c-*/exercise))))
exercise_name = $(subst $() $(),/,$(wordlist 1,2,$(subst -, ,$1)))

# Check's own header says what is asserted, and in which words.
CHECK_HEADER = $(shell echo '\#include <check.h>' | $(CC) -E - 2> /dev/null | sed -n 's/^\# 1 "\(.*\)check\.h".*/\1/p')
$(WORKSHOP)/include/check.h:
	@mkdir -p $(@D)
	$(Q)cp $(CHECK_HEADER)check.h $(CHECK_HEADER)check_stdint.h $(@D)

JUDGED := $(WASM) $(EXACT) -O2 -gline-tables-only -gdwarf-4 -msimd128 -fno-inline -w -Iexercises -I$(WORKSHOP)/include $(ROOMS) -MMD -MP
# The sanitizers of the desk.
WATCHED := -Xclang -fsanitize=address -Xclang -fsanitize-address-use-after-return=never \
  -mllvm -asan-instrumentation-with-call-threshold=0 -mllvm -asan-mapping-offset=268435456
TESTED := -include exercises/judge.h -Dmain=judge_main \
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
	$(call judged,-fno-builtin)
-include $(wildcard $(WORKSHOP)/*.d $(WORKSHOP)/*/*.d $(WORKSHOP)/exercises/*/*.d)

# What each is linked of.
$(WORKSHOP)/parts.mk: figures/workshop/parts.sh exercises/judge.sh Makefile $(EXERCISES:%=exercises/%/exercise)
	@mkdir -p $(@D)
	$(Q)BUILD='$(BUILD)' sh figures/workshop/parts.sh $(WORKSHOP) $(OURS) $(foreach e,$(EXERCISES),$(call exercise_name,$e)) > $@.new && mv $@.new $@
ifneq ($(filter site% test-site workshop%,$(MAKECMDGOALS)),)
include $(WORKSHOP)/parts.mk
endif

$(EXERCISES:%=$(WORKSHOP)/%.o): $(WORKSHOP)/%.o: $(WORKSHOP)/judge_page.o
	@echo "  link  $@"
	$(Q)wasm-ld -r $^ -o $@
$(EXERCISES:%=$(WORKSHOP)/%.js): $(WORKSHOP)/%.js: figures/workshop/pack.mjs exercises/cut.awk
	@echo "  pack  $@"
	$(Q)node figures/workshop/pack.mjs exercise $* $(WORKSHOP)/$*.o $(ANSWER_$*) $(SOURCE_$*) > $@

.PHONY: workshop-files
workshop-files: $(EXERCISES:%=$(WORKSHOP)/%.js)
