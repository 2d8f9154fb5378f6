# site.mk - the book as pages for a browser: build/site, to be opened from the disk
# or put on any static host.

SITE  := $(BUILD)/site
WOVEN := $(patsubst chapters/woven/%,%,$(wildcard chapters/woven/*.md))
SITE_PAGES := $(WOVEN:%.md=$(SITE)/%.html) $(SITE)/index.html $(SITE)/exercises.html

# Pictures: WebP of a PNG, the others as they are; and the data of tables.
PICTURES   := $(filter figures/%,$(wildcard figures/*/*.png figures/*/*.svg figures/*/*.webp figures/*/*.csv))
SITE_FILES := $(patsubst %.png,%.webp,$(PICTURES:%=$(SITE)/%))
# What a caption links to: the book's code, the programs of the figures, and what
# the exercises declare.
SOURCES    := $(sort $(shell sh chapters/weave.sh) $(wildcard figures/[0-9]*/*.c figures/peers/*.c figures/live/*.c figures/scenes/*.[ch] figures/manual/*.c exercises/*/*.h))
SITE_CODE  := $(patsubst %,$(SITE)/source/%.html,$(subst /,-,$(SOURCES)))
# The first frames of what moves.
STILLS     := $(patsubst %.webp,%-still.webp,$(wildcard figures/moving/*.webp))
SITE_STYLE := $(patsubst %,$(SITE)/%,style.css site.js icon.svg math.woff2 pagella-regular.woff2 pagella-italic.woff2 pagella-bold.woff2 minisearch.js $(STILLS))
# The workshop, where its compiler could be fetched: a page for each exercise.
WITH_WORK  := $(wildcard $(WORK)/.done)
SITE_WORK  := $(if $(WITH_WORK),$(WORKSHOP_FILES:$(WORKSHOP)/%=$(SITE)/workshop/%) $(SITE)/workshop/.done)
SITE_PAGES += $(if $(WITH_WORK),$(WORKED:%=$(SITE)/write-%.html) $(SITE)/little.html)
SITE_LIVE  := $(LIVE_FILES:$(BUILD)/live/%=$(SITE)/live/%)

.PHONY: site
site: need-site book workshop-tools
	+$(Q)$(AGAIN) $(if $(findstring j,$(firstword -$(MAKEFLAGS))),,-j2) site-files
	@echo "$(SITE)/index.html: $$(ls $(SITE)/*.html | wc -l) pages"
.PHONY: site-files
# What takes long comes first: so nothing waits for it at the end.
site-files: $(if $(WITH_WORK),$(WORKSHOP)/compiler.js) $(SITE)/search.js $(SITE_LIVE) $(SITE_WORK) $(SITE_PAGES) $(SITE_FILES) $(SITE_CODE) $(SITE_STYLE)

# Charts, laid out for a narrow page.
CHARTS_SITE := $(filter %.svg,$(PICTURES))
$(BUILD)/phone.done: $(CHARTS_SITE) chapters/site/phone.mjs
	@mkdir -p $(dir $(CHARTS_SITE:%=$(SITE)/%))
	$(Q)node chapters/site/phone.mjs $(foreach f,$(CHARTS_SITE),$f $(SITE)/$(f:.svg=-phone.svg)) && touch $@
$(SITE_PAGES): | $(BUILD)/phone.done

PAGE_TOOLS := $(wildcard chapters/site/*.lua) $(addprefix chapters/site/,page.awk page.sh page.html openings.txt) $(WORKSHOP)/with $(BUILD)/names $(BUILD)/asked
define page
	@mkdir -p $(@D)
	@echo "  page  $@"
	$(Q)BUILD='$(BUILD)' SITE_URL='$(SITE_URL)' sh chapters/site/page.sh $1
endef
$(SITE)/index.html: chapters/site/index.md chapters/site/index.awk README.md $(PAGE_TOOLS)
	$(call page,index $@)
$(SITE)/exercises.html: $(wildcard exercises/*/README.md) $(PAGE_TOOLS)
	$(call page,exercises $@)
$(SITE)/little.html: chapters/little/stages.txt $(PAGE_TOOLS)
	$(call page,little $@)
$(SITE)/write-%.html: exercises/%/README.md $(PAGE_TOOLS)
	$(call page,write $@ $*)
$(SITE)/%.html: chapters/woven/%.md tests/bits/bits.txt $(PAGE_TOOLS)
	$(call page,page $@ $*)

# No wider than twice the column for pictures: a PNG tells its width in bytes 19, 20.
$(SITE)/figures/%.webp: figures/%.png
	@mkdir -p $(@D)
	$(Q)wide=$$(od -An -tu1 -j18 -N2 $< | awk '{ print 256 * $$1 + $$2 }'); [ "$$wide" -gt 1472 ] && shrink='-resize 1472 0'; \
	  cwebp -quiet -preset drawing -q 75 -m 6 $$shrink $< -o $@
$(SITE)/figures/%: figures/%
	@mkdir -p $(@D)
	$(Q)cp $< $@
$(SITE)/figures/moving/%-still.webp: figures/moving/%.webp
	@mkdir -p $(@D)
	$(Q)webpmux -get frame 1 $< -o $@ 2> /dev/null
$(SITE)/minisearch.js: $(BUILD)/node/.done
	$(Q)cp $(BUILD)/node/node_modules/minisearch/dist/umd/index.js $@
$(SITE)/workshop/%: $(WORKSHOP)/%
	@mkdir -p $(@D)
	$(Q)cp $< $@
# The compiler's pieces.
$(SITE)/workshop/.done: $(WORKSHOP)/workshop.js
	@mkdir -p $(@D)
	$(Q)rm -f $(@D)/clang-*.js && cp $(WORKSHOP)/clang-*.js $(@D) && touch $@
$(SITE)/live/%: $(BUILD)/live/%
	@mkdir -p $(@D)
	$(Q)cp $< $@
$(SITE)/%: chapters/site/%
	@mkdir -p $(@D)
	$(Q)cp $< $@
# Where the book has which lines: file, line, page; and what names.lua looks for, to
# which any page may lead.
$(BUILD)/places: FORCE
	$(Q)mkdir -p $(@D) && awk '/^\[[^],]*, lines* [0-9]/ { split(substr($$0, 2), a, ", lines* "); n = FILENAME; gsub(/.*\/|\.md$$/, "", n); print a[1], a[2] + 0, n }' \
	  $(WOVEN:%=chapters/woven/%) > $@.new
	$(Q)cmp -s $@.new $@ || cp $@.new $@
$(BUILD)/names: FORCE
	$(Q)mkdir -p $(@D) && awk -f chapters/site/names.awk $(WOVEN:%=chapters/woven/%) > $@.new
	$(Q)cmp -s $@.new $@ || cp $@.new $@
# The exercises, in the order in which the chapters tell of them.
$(BUILD)/asked: FORCE
	$(Q)mkdir -p $(@D) && sed -n 's|^- `make exercise \([0-9a-z]*\)/\([0-9a-z_]*\)`.*|\1-\2|p' $(WOVEN:%=chapters/woven/%) > $@.new
	$(Q)cmp -s $@.new $@ || cp $@.new $@
define source
$(SITE)/source/$(subst /,-,$1).html: $1 chapters/site/source.awk $(BUILD)/places
	@mkdir -p $$(@D)
	$(Q)LC_ALL=C awk -f chapters/site/source.awk $(BUILD)/places $1 > $$@
endef
$(foreach f,$(SOURCES),$(eval $(call source,$f)))

# What search looks through.
$(SITE)/search.js: $(WOVEN:%=chapters/woven/%) chapters/site/search.lua $(PAGE_TOOLS)
	@echo "  page  $@"
	$(Q)sh chapters/site/page.sh search $@

# The whole book in one file.
html pdf epub: need-book $(BUILD)/names $(SITE_FILES) $(STILLS:%=$(SITE)/%)
	$(Q)BUILD='$(BUILD)' sh chapters/site/page.sh $@ $(BUILD)/book.$@

# The pages in a real browser: what moves first, then how long pages load.  All run,
# even if one fails.  SEED repeats a random walk over dials.
.PHONY: test-site
test-site: need-browser site $(BUILD)/node/.done
	$(Q)sh tests/script/check_charts.sh $(CHARTS_SITE:%.svg=$(SITE)/%-phone.svg)
	$(Q)bad=; \
	  $(if $(PAGES),,node tests/site/check_live.mjs $(BUILD) || bad=1; \
	    node tests/site/check_look.mjs $(BUILD) || bad=1; \
    node tests/site/check_dials.mjs $(BUILD) $(SEED) || bad=1; \
    node tests/site/check_workshop.mjs $(BUILD) $(or $(WRONGS),2) || bad=1;) \
	  node tests/site/check_site.mjs $(SITE) $(PAGES) || bad=1; [ -z "$$bad" ]
