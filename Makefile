# Makefile - every command of tumble; bare `make` prints them.
# A line that opens with #: is a line of that help.

# The book's order, chapter/module, one a line.  A module may use only modules
# above it: its tests are linked with those and no others, so a wrong arrow
# cannot link.  A module's files stand in a folder of lib/; its name is its own.
define ORDER
00/vec3
00/status
01/verlet
02/constraint
03/mesh
03/body
03/rigidity
03/convex
04/wide
04/gjk
05/climb
05/feature
05/hit_face
06/sphere
06/sphere_tree
07/response
08/ordering
09/scene
09/system
10/hull
10/capsule
10/cylinder
10/search
10/rim
10/query
10/obj
11/manifold
12/inline
12/taut
12/angular
12/line
12/bend
13/arctan
13/rigid4
13/weight
13/rounding
13/real4
13/task
13/table
13/motion
13/material
13/contact
13/passes
13/passes_wide
13/solver
14/aabb_tree
14/broad
14/pairs
14/grid
15/swept
15/collide
15/cast
15/impact
15/restitution
15/blow
16/placed
16/separation
16/obstacle
16/facet
16/near
16/touch
16/certificate
16/soft
17/joint
17/actuator
17/linkage
17/pin
18/cache_tables
18/seams
18/cache
18/sleep
18/world
18/handle
18/ledger
18/soft_step
18/join
18/drive
18/advance
18/substeps
18/rungs
18/ahead
18/guard
18/rolling
18/hear
18/step
18/measure
19/store
19/snapshot
19/surface
19/tumble
19/slots
19/inside
19/tumble_turn
19/tumble_world
19/tumble_shapes
19/tumble_bodies
19/tumble_mesh
19/tumble_state
19/tumble_joints
19/tumble_steer
19/tumble_ask
19/tumble_walk
19/tumble_contacts
19/tumble_hear
19/tumble_draw
19/tumble_save
endef
LINE := $(strip $(ORDER))

# --- The compiler -------------------------------------------------------------
# May be set by hand: make test CC=clang CFLAGS=-O0 BUILD=build/clang
BUILD  := build
# make little has a program of the reader's own, and no module.
ifneq ($(filter little little-film little-page,$(MAKECMDGOALS)),)
LITTLE := $(MINE)
override MINE :=
endif
# With modules of the reader's own (MINE=) programs go to a folder of their own.
# All objects but those modules' are ours, and are built where ours are.
ifneq ($(MINE),)
ifeq ($(findstring /swapped,$(BUILD)),)
override BUILD := $(BUILD)/swapped
endif
endif
OURS := $(BUILD:%/swapped=%)
CFLAGS ?= -O3 -g
# It knows the archiver of what it compiles for.
ifeq ($(origin AR),default)
AR = $(shell $(CC) -print-prog-name=ar)
endif
ifdef NATIVE
CFLAGS += -march=native
endif
# The same bits everywhere: no fused multiply-add, no fast math, plain C11.
EXACT    := -std=c11 -ffp-contract=off -fno-math-errno -fno-trapping-math
WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wdouble-promotion -Wshadow \
  -Wstrict-prototypes -Wmissing-prototypes -Wvla -Wpointer-arith -Wcast-qual \
  -Wwrite-strings -Wundef -Wnull-dereference -Wformat=2 -Wimplicit-fallthrough
COMPILE   = $(CC) $(EXACT) $(CFLAGS) $(WARNINGS)
CHECK_LIBS ?= -lcheck -lsubunit -lm -lrt -lpthread
Q     := $(if $(V),,@)
AGAIN := $(MAKE) --no-print-directory
# What is built is built by all cores (JOBS=1: by one), unless make has its own -j.
CORES := $(or $(JOBS),$(shell nproc 2> /dev/null || echo 2))
BUILT  = +$(Q)$(AGAIN) $(if $(filter -j%,$(MAKEFLAGS)),,-j$(CORES) -O)

# --- What there is ------------------------------------------------------------
MODULES  := $(notdir $(LINE))
# Two digits, and for what came later a letter: 00b stands between 00 and 01.
# Some have no module of their own: 20 is about the hard cases, 21 about speed.
CHAPTERS := $(patsubst chapters/%,%,$(foreach c,$(wildcard chapters/[0-9]*.md),$(firstword $(subst -, ,$c))))
# Tests in the book's order, then those that belong to no module.
TESTS    := $(basename $(notdir $(wildcard $(MODULES:%=tests/*/check_%.c))))
TESTS    += $(filter-out $(TESTS),$(basename $(notdir $(wildcard tests/*/check_*.c))))
FIGURES  := $(basename $(notdir $(wildcard figures/[0-9]*/*.c)))
PEERS    := $(notdir $(wildcard figures/peers/peers*.c))
PILES    := $(basename $(notdir $(wildcard figures/peers/piles*.c figures/peers/piles*.cpp)))
# These, and piles_bullet.cpp, need libccd, ODE and Bullet; box3d_mover.c needs Box3D and
# jolt_mover.cpp Jolt.
THEIRS   := peers_ccd.c peers_ode.c piles_ode.c
# Those of chapter 19b that have a main of their own are no scenes.
ALONE    := loop replay rollouts
SCENES   := $(filter-out example_main.c $(ALONE:%=%.c),$(notdir $(wildcard figures/scenes/*.c figures/manual/*.c)))
PAINTER  := $(filter-out shrink.c paint_little.c main.c,$(notdir $(wildcard figures/draw/*.c figures/measure/*.c figures/command/*.c))) $(SCENES)
CHECKS   := $(TESTS:%=$(BUILD)/tests/%)
FUZZERS  := $(basename $(notdir $(wildcard tests/fuzz/fuzz_*.c)))

# UPTO_mesh: the objects of the line up to mesh.  UPTO_04: up to the last module
# of chapter 04.  At the end ALL is the whole library.
ALL :=
define module
ALL += $(patsubst %.c,$(BUILD)/lib/%.o,$(notdir $(wildcard lib/*/$(notdir $1).c)))
UPTO_$(notdir $1) := $$(ALL)
UPTO_$(patsubst %/,%,$(dir $1)) := $$(ALL)
TESTS_$(patsubst %/,%,$(dir $1)) += $(filter check_$(notdir $1),$(TESTS))
endef
$(foreach m,$(LINE),$(eval $(call module,$m)))
# What a chapter sees: one without modules sees what the chapter before it does.
$(foreach c,$(CHAPTERS),$(eval SEES_$c := $(or $(UPTO_$c),$(SEES)))$(eval SEES := $(SEES_$c)))
TESTS_09 += check_poses check_experiments
UPTO_poses := $(UPTO_09)
UPTO_experiments := $(UPTO_scene)
TESTS_20 := check_hard check_families
TESTS_21 := check_clock check_thread
# The figures of 00 to 08 see Part I up to their chapter; later ones may ask what
# a module does to the whole, and chapter 09 sets the engine beside its system.
FLOOR = $(if $(filter 00% 01% 02% 03% 04% 05% 06% 07% 08%,$1),$(SEES_$1),$(ALL))

# A goal with a sign that means something to make or to the shell is none.
define NEWLINE


endef
SIGNS := ; & | < > ( ) { } [ ] $$ * ? ! ~ ^ \# % : " \ ' ` ,
ifneq ($(strip $(foreach s,$(SIGNS),$(findstring $s,$(MAKECMDGOALS))) $(if $(findstring $(NEWLINE),$(MAKECMDGOALS)),x)),)
$(error $(MAKECMDGOALS): the name of a command or an exercise has no such sign)
endif

# After `watch`, `exercise` and their like a chapter says of what: it is no goal
# of its own.
ifneq ($(filter watch live exercise hint solution reset progress little,$(MAKECMDGOALS)),)
NAMED := $(filter $(CHAPTERS),$(MAKECMDGOALS))
endif
MADE := $(filter-out $(NAMED),$(CHAPTERS))

# What the commands `make 04`, `make test-04` and `make figure-04` need.
define chapter
FIGURES_$1 := $(filter $1-%,$(FIGURES))
tests-of-$1: $(UPTO_$1) $(TESTS_$1:%=$(BUILD)/tests/%)
figures-of-$1: $(patsubst %,$(BUILD)/figures/%,$(filter $1-%,$(FIGURES)))
figure-$1: figures-of-$1
endef

.DEFAULT_GOAL := help
.SECONDEXPANSION:
.SECONDARY:
.DELETE_ON_ERROR:
.PHONY: lines help deps deps-book deps-site deps-dev deps-peers demo test test-course checks objects book html pdf epub library \
  figures hard coverage bits sanitize valgrind fuzz fuzzers strict clean FORCE $(CHAPTERS) \
  $(CHAPTERS:%=test-%) $(CHAPTERS:%=figure-%) $(FIGURES:%=figure-%) \
  $(CHAPTERS:%=tests-of-%) $(CHAPTERS:%=figures-of-%) demo-programs
$(foreach c,$(CHAPTERS),$(eval $(call chapter,$c)))

#:
#: Begin here
#:   make deps       install what is missing (Check, gnuplot, libpng, and
#:                   aspell for the spelling of the book)
#:   make demo       run the three scenes, draw them, print a table
#:   make test       build and run every test of the library, and check that the
#:                   book says what it does; make test-course: the exercises, the
#:                   little program, the commands and the page
help:
	@b=; r=; if [ -t 1 ]; then b=$$(printf '\033[1m'); r=$$(printf '\033[0m'); fi; \
	sed -n "s/^#: \([A-Z][a-z ]*\)$$/$$b\1$$r/p; t; s/^#: \{0,1\}//p" Makefile

deps deps-book deps-site deps-dev deps-peers:
	@CC='$(CC)' sh tests/script/deps.sh $@
# What a command needs of others, and what installs it: looked for before any work,
# so need-charts stands first where a rule is that draws.
NEED_check    := deps check
NEED_charts   := deps gnuplot-nox libpng-dev
NEED_book     := deps-book pandoc webp
NEED_moving   := deps-book webp
NEED_site     := deps-site check pandoc clang lld wasi-libc nodejs npm webp
NEED_browser  := deps-site nodejs chromium webp
NEED_valgrind := deps-dev valgrind
NEED_clang    := deps-dev clang
NEED_fuzz     := deps-dev clang libclang-rt-dev
NEEDS := $(patsubst NEED_%,need-%,$(filter NEED_%,$(.VARIABLES)))
.PHONY: $(NEEDS)
$(NEEDS): need-%:
	@CC='$(CC)' sh tests/script/deps.sh $(NEED_$*)

DEMO := room cloth-on-cube cloth-on-rope
demo-programs: $(BUILD)/tumble $(FIGURES_09:%=$(BUILD)/figures/%)
demo: need-charts
	$(BUILT) demo-programs
	$(Q)mkdir -p $(BUILD)/demo
	$(Q)for scene in $(DEMO); do \
	  $(BUILD)/tumble $$scene --film $(BUILD)/demo/$$scene.png || { \
	  $(if $(MINE),echo "The scene $$scene fails with $(MINE); what is not so says\
	    make test MINE='$(MINE)'" >&2;) exit 1; }; done
	$(Q)export TUMBLE_QUICK=1; $(foreach f,$(FIGURES_09),$(call draw,$f,$(BUILD)/demo) &&) true
	@echo "The pictures and charts are in $(BUILD)/demo:" && ls $(BUILD)/demo/*.png $(BUILD)/demo/*.svg

# Every test runs, even if another one fails or does not build.
COURSE := $(patsubst %,tests/script/check_%.sh,exercises little page command follow \
  start hints swap weave make readme)
TRIED_test        := $(CHECKS) $(filter-out $(COURSE),$(wildcard tests/script/check_*.sh))
TRIED_test-course := $(COURSE)
test test-course: need-check
	$(BUILT) -k checks public single || touch $(BUILD)/unbuilt
	@unbuilt=; ! rm $(BUILD)/unbuilt 2> /dev/null || unbuilt=1; \
	MINE= YOURS='$(MINE)' BUILD='$(BUILD)' JOBS=$(CORES) UNBUILT=$$unbuilt \
	  sh tests/script/run.sh $(TRIED_$@)
# One after the other: both build the same.
$(if $(filter test,$(MAKECMDGOALS)),$(eval test-course: test))

#:
#: Read and learn
#:   make 04         chapter 04 alone (there are 00 to 26): the library up to it
#:                   and nothing above, its tests, its figures in build/figures,
#:                   how its exercises stand, and what to read next
#:   make test-04    its tests alone
#:   make book       weave chapters/, lib/ and the judges into book.md, and into
#:                   a page a chapter: chapters/woven
#:   make site       the book as pages for a browser, with live figures:
#:                   build/site/index.html (make deps-site); SITE_URL=ADDRESS says
#:                   in each page where it will stand, for those who pass it on
#:   make html       build/book.html, one page with all in it; make pdf (two volumes:
#:                   the chapters, and the listings, build/book-2.pdf) and make
#:                   epub: for paper and for e-readers (make deps-book)
#:   make live 01    the live figures of chapter 01, in a page (make deps-site)
#:   make library    build/libtumble.a
#:   make install    tumble.h, the library, and what pkg-config and CMake ask for
#:                   (PREFIX=/usr/local, LIBDIR=PREFIX/lib, DESTDIR=); make
#:                   uninstall removes them.  lib/CMakeLists.txt is for CMake
#:   make single     the library as one file: build/tumble.c and build/tumble.h
#:   make python     a wheel of it for Python: build/tumble-*.whl
$(CHAPTERS:%=test-%): test-%: need-check
	$(BUILT) tests-of-$*
	$(Q)$(if $(TESTS_$*),MINE= YOURS='$(MINE)' JOBS=$(CORES) sh tests/script/run.sh $(TESTS_$*:%=$(BUILD)/tests/%),:)
$(MADE): %: need-charts test-%
	$(BUILT) figures-of-$@
	$(Q)export TUMBLE_QUICK=1; $(foreach f,$(FIGURES_$@),$(call draw,$f,$(BUILD)/figures) &&) true
	@CC='$(CC)' BUILD='$(BUILD)' sh exercises/run.sh chapter $@

book:
	$(Q)sh chapters/weave.sh $(BUILD)
	$(Q)awk -f chapters/numbers.awk -f chapters/readme.awk README.md > $(BUILD)/README.md
	$(Q)mkdir -p chapters/woven && for f in chapters/woven/*; do [ -e $(BUILD)/woven/$${f##*/} ] || rm -f "$$f"; done
	$(Q)cd $(BUILD) && for f in README.md book.md woven/*; do \
	  case $$f in woven/*) to='$(CURDIR)'/chapters/$$f ;; *) to='$(CURDIR)'/$$f ;; esac; cmp -s $$f "$$to" || cp $$f "$$to"; done
	@echo "book.md: $$(wc -l < book.md) lines; a page a chapter: chapters/woven"


library:
	$(BUILT) $(BUILD)/libtumble.a

# What is installed: tumble.h, and a library in which no other name is seen.
PREFIX     ?= /usr/local
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
LICENCE     = $(PREFIX)/share/licenses/tumble
VERSION := $(shell sed -n 's/^\#define TUMBLE_VERSION "\(.*\)"/\1/p' lib/tumble.h)
MAJOR   := $(firstword $(subst ., ,$(VERSION)))
# Only where objects are ELF is there a shared library; elsewhere CMake makes one.
ELF     = $(filter linux% %bsd freebsd%,$(subst -, ,$(shell $(CC) -dumpmachine)))
SHARES  = libtumble.so.$(VERSION) libtumble.so.$(MAJOR) libtumble.so
CONFIG  = $(LIBDIR)/cmake/tumble
INSTALLED = $(patsubst %,$(LIBDIR)/%,libtumble.a $(if $(ELF),$(SHARES)) pkgconfig/tumble.pc) \
  $(CONFIG)/tumbleConfig.cmake $(CONFIG)/tumbleConfigVersion.cmake $(INCLUDEDIR)/tumble.h $(LICENCE)/LICENSE
# A program is told where the library stands, unless the loader looks there anyway.
LOADED = $(filter /usr/lib% /lib%,$(LIBDIR)) $(filter $(LIBDIR),$(shell \
  /sbin/ldconfig -vN 2> /dev/null | sed -n 's|^\(/[^:]*\):.*|\1|p'))
RPATH  = $(if $(strip $(LOADED))$(if $(ELF),,x),,-Wl,-rpath,$${libdir} )
.PHONY: install uninstall public
ifneq ($(filter install uninstall,$(MAKECMDGOALS)),)
$(foreach v,PREFIX LIBDIR INCLUDEDIR,$(if $(filter-out 1,$(words $($v)))$(filter-out /%,$($v)),\
  $(error $v=$($v): this must begin with / and have no blank)))
endif
install:
	$(Q)for d in $(LIBDIR)/pkgconfig $(CONFIG) $(LIBDIR) $(INCLUDEDIR) $(LICENCE); do \
	  install -d '$(DESTDIR)'$$d 2> /dev/null && [ -w '$(DESTDIR)'$$d ] || { echo "make install:\
	  $(DESTDIR)$$d cannot be written; PREFIX=FOLDER installs elsewhere" >&2; exit 1; }; done
	$(BUILT) public
	$(Q)install -m 644 $(BUILD)/seen.a '$(DESTDIR)$(LIBDIR)/libtumble.a'
	$(Q)$(if $(ELF),install $(BUILD)/seen.so '$(DESTDIR)$(LIBDIR)/libtumble.so.$(VERSION)')
	$(Q)$(if $(ELF),ln -sf libtumble.so.$(VERSION) '$(DESTDIR)$(LIBDIR)/libtumble.so.$(MAJOR)')
	$(Q)$(if $(ELF),ln -sf libtumble.so.$(MAJOR) '$(DESTDIR)$(LIBDIR)/libtumble.so')
	$(Q)for f in Config ConfigVersion; do sed 's|@VERSION@|$(VERSION)|; s|@MAJOR@|$(MAJOR)|; s|@LIBDIR@|$(LIBDIR)|; s|@INCLUDEDIR@|$(INCLUDEDIR)|' \
	  lib/tumble$$f.cmake.in > '$(DESTDIR)$(CONFIG)'/tumble$$f.cmake || exit 1; done
	$(Q)install -m 644 lib/tumble.h '$(DESTDIR)$(INCLUDEDIR)'
	$(Q)install -m 644 LICENSE '$(DESTDIR)$(LICENCE)'
	$(Q)printf '%s\n' 'prefix=$(PREFIX)' 'libdir=$(LIBDIR:$(PREFIX)/%=$${prefix}/%)' \
	  'includedir=$(INCLUDEDIR:$(PREFIX)/%=$${prefix}/%)' 'Name: tumble' 'Version: $(VERSION)' \
	  'Description: rigid and deformable bodies of particles and sticks' \
	  'Cflags: -I$${includedir}' 'Libs: -L$${libdir} $(RPATH)-ltumble -lm' \
	  > '$(DESTDIR)$(LIBDIR)/pkgconfig/tumble.pc'
	@echo "installed:" $(INSTALLED)
	@$(if $(DESTDIR)$(RPATH)$(if $(ELF),,x),:,/sbin/ldconfig 2> /dev/null || echo "The loader has to be told: ldconfig, as root.")
uninstall:
	$(Q)for f in $(INSTALLED); do rm -f '$(DESTDIR)'$$f || exit 1; done
	$(Q)for d in $(LICENCE) $(CONFIG); do [ ! -d '$(DESTDIR)'$$d ] || rmdir '$(DESTDIR)'$$d; done
	@echo "removed:" $(INSTALLED)
public: $(BUILD)/seen.a $$(if $$(ELF),$(BUILD)/seen.so)

# One file, made by a script, for those who want no other; and Python's.
.PHONY: single python
single: $(BUILD)/tumble.c $(BUILD)/tumble.h
	@echo "$^: cc -O2 -c tumble.c"
$(BUILD)/tumble.c: lib/single.awk LICENSE $(wildcard lib/*.h lib/*/*.[ch])
	$(Q)mkdir -p $(@D)
	$(Q)awk -v order='$(MODULES)' -f $^ > $@.part && mv $@.part $@
$(BUILD)/tumble.h: lib/tumble.h
	$(Q)mkdir -p $(@D)
	$(Q)sed '/^\/\/[<>]/d' $< > $@
python: $(BUILD)/seen.o
	$(Q)CC='$(CC)' TUMBLE_OBJECT='$(BUILD)/seen.o' python3 lib/python/build_wheel.py $(BUILD)

#:
#: The little program
#:   make little      its stages, and how far yours is (my/little.c, or MINE=FILE)
#:   make little 07b  that stage, run; yours beside it, and what differs
#:   make little-film     the room of Part I, moving: yours, or ours
#:   make little-film 18  the engine of Part II
#:   make little-page 18  a page of it, yours beside ours, to send to a friend
#:   make little-films    those of the book, renewed: figures/little/*.webp
#:   make little-measured   what all stages print, renewed: the book's numbers
#:   make little-beside    its last stage beside the library: figures/little/beside.csv
#:   make little-rows      which hard cases that stage holds: figures/little/rows.csv
STAGES := $(shell sed -n 's/^\([0-9][0-9][a-z]\) .*/\1/p' chapters/little/stages.txt)
STAGE  := $(filter-out little little-film little-films little-page,$(MAKECMDGOALS))
.PHONY: little little-film little-films little-page little-measured little-beside little-rows $(filter-out $(CHAPTERS),$(STAGES))
little-measured:
	$(Q)CC='$(CC)' BUILD='$(BUILD)' sh chapters/little/little.sh printed > $(BUILD)/printed.txt && mv $(BUILD)/printed.txt chapters/little/printed.txt
	$(Q)CC='$(CC)' BUILD='$(BUILD)' sh chapters/little/little.sh measured > $(BUILD)/measured.csv && mv $(BUILD)/measured.csv chapters/little/measured.csv
	$(Q)BUILD='$(BUILD)' sh chapters/little/little.sh table > $(BUILD)/stages.csv && mv $(BUILD)/stages.csv figures/tables/stages.csv
little-film little-films little-page:
	$(Q)MINE='$(if $(filter %films,$@),,$(LITTLE))' CC='$(CC)' BUILD='$(BUILD)' AGAIN='$(AGAIN)' sh chapters/little/little.sh $(@:little-%=%) $(firstword $(STAGE))
little-beside: $(BUILD)/libtumble.a
	$(Q)CC='$(CC)' BUILD='$(BUILD)' sh figures/little/beside.sh > $(BUILD)/beside.csv && mv $(BUILD)/beside.csv figures/little/beside.csv
little-rows:
	$(Q)mkdir -p $(BUILD) && CC='$(CC)' sh figures/little/rows.sh > $(BUILD)/rows.csv && mv $(BUILD)/rows.csv figures/little/rows.csv
little:
	$(Q)MINE='$(LITTLE)' CC='$(CC)' BUILD='$(BUILD)' AGAIN='$(AGAIN)' sh chapters/little/little.sh $(if $(STAGE),run $(firstword $(STAGE)),list)
# After `little` a stage, or a chapter, says of what: it is no goal of its own.
ifneq ($(filter little little-film little-page,$(MAKECMDGOALS)),)
.PHONY: $(STAGE)
$(STAGE):
	@:
else
$(filter-out $(CHAPTERS),$(STAGES)):
	$(Q)$(AGAIN) little $@
endif

#:
#: Exercises
#:   make exercise [01]       which there are (in a chapter), and how far you are
#:   make exercise 01/step    begin it; after that, judge what you wrote
#:   make hint 01/step        the next of its three hints
#:   make solution 01/step    the book's answer (asks first)
#:   make reset 01/step       begin again (what you had is kept)
#:   make progress            a bar for each chapter (exercises/progress.txt)
#:   make watch 01/step       judge it again whenever you save it
#:   make live 01/step        the chapter's live figures, with what you wrote
#:   make watch 01            the tests of chapter 01 whenever you save a file,
#:                            and any exercise whose file you save
#:   make check-exercises     is every exercise sound, with all its wrong
#:                            answers (make test-course tries two), and the runner?
READER := exercise hint solution reset progress
WHICH  := $(NAMED) $(foreach goal,$(MAKECMDGOALS),$(if $(findstring /,$(goal)),$(goal)))
# The runner says what no exercise has for its name.
ifneq ($(filter $(READER) watch,$(MAKECMDGOALS)),)
WHICH := $(filter-out $(READER) watch,$(MAKECMDGOALS))
endif
.PHONY: $(READER) watch check-exercises
# What fails, make ends with a line of its own, `make: *** ...`, and the last word
# is the judge's.  To a question (-q) make runs only what begins with a plus, and
# if that ends with 1, so does make, and says nothing.
ifneq ($(filter $(READER),$(MAKECMDGOALS)),)
ifeq ($(filter-out $(READER) $(WHICH),$(MAKECMDGOALS))$(findstring n,$(firstword -$(MAKEFLAGS))),)
MAKEFLAGS += -q
QUIETLY := +
endif
endif
$(READER):
	$(QUIETLY)@MINE= CC='$(CC)' BUILD='$(BUILD)' sh exercises/run.sh $@ $(WHICH) || exit 1
watch:
	@AGAIN='$(AGAIN)' MINE='$(MINE)' CC='$(CC)' BUILD='$(BUILD)' \
	  exec sh exercises/watch.sh $(WHICH)
check-exercises:
	@CC='$(CC)' BUILD='$(BUILD)' WRONGS= sh tests/script/check_exercises.sh

# To make, what is named after the command is a goal: one with nothing to do.
ifneq ($(and $(WHICH),$(filter $(READER) watch live,$(MAKECMDGOALS))),)
NOTHING := $(NAMED) $(foreach goal,$(WHICH),$(if $(findstring /,$(goal)),$(goal)))
.PHONY: $(NOTHING)
$(NOTHING) .DEFAULT:
	$(QUIETLY)@:
else
# Nor is a folder's name a command, though make would call it up to date.
.PHONY: chapters exercises lib tests
chapters exercises lib tests .DEFAULT:
	@sh tests/script/meant.sh '$@' $(CHAPTERS)
endif

#:
#: Swap in your own
#:   make test-04 MINE=my/gjk.c    chapter 04's tests, with your gjk for ours
#:   make demo MINE='my/distance.c my/verlet.c'    the three scenes, with yours
#:   make live 01 MINE=my/verlet.c    the live figures of chapter 01, with yours
# The name of a file says which module it is.  It may stand anywhere.
ifneq ($(MINE),)
swapped = $(addprefix $(BUILD)/lib/,$(notdir $(1:.c=.o)))
refuse = $(if $1,$(error $2))
define swap
$(call refuse,$(if $(wildcard $1),,x),$1: there is no such file)
$(call refuse,$(wildcard $1/.),$1: this is a folder)
$(call refuse,$(if $(filter $(call swapped,$1),$(ALL)),,x),$1: no module of \
  lib/ has that name)
$(call refuse,$(filter-out 1,$(words $(filter %/$(notdir $1),$(MINE:%=./%)))),\
  $(MINE): two files for one module)
$(foreach c,$(filter $(CHAPTERS),$(MAKECMDGOALS:test-%=%)),$(call \
  refuse,$(if $(filter $(call swapped,$1),$(SEES_$c)),,x),$1: \
  its module comes after chapter $c))
$(call swapped,$1): $1 $(BUILD)/flags $(BUILD)/mine
	$$(compile) || { echo "$1: does not compile; begin with the first error\
	 above" >&2; exit 1; }
endef
$(foreach f,$(MINE),$(eval $(call swap,$f)))
# Every other object is ours.  What was another's before is taken anew.
TAKEN := $(filter-out $(foreach f,$(MINE),$(call swapped,$f)),$(ALL))
$(TAKEN): $(BUILD)/mine
$(TAKEN) $(foreach d,tests figures,$(patsubst %.c,$(BUILD)/$d/%.o,$(notdir \
  $(wildcard $d/*/*.c)))): $(BUILD)/%: $(OURS)/%
	$(Q)mkdir -p $(@D) && cp $< $@
$(BUILD)/mine: FORCE
	@mkdir -p $(@D)
	@echo '$(MINE)' | cmp -s - $@ || echo '$(MINE)' > $@
endif

#:
#: Measure
#:   make stale      which figures and tables are older than what makes them, and
#:                   than what of it
#:   make figures    run the program of every such figure, renew its data and its
#:                   picture (ALL=1: of every figure), and gather the tables
#:   make figure-08  the same for the figures of chapter 08
#:   make charts     draw every chart from the data as they are; nothing is run
#:   make moving     the moving pictures of README and chapter 18 (make deps-book)
#:   make coverage   which lines of lib/ do the tests run, which branches both ways?
#:   make hard       run the hard cases, each beside its target: on the engine
#:                   (figures/tables/hard.csv), and on the system of Part I,
#:                   which falls short in many; fails if the engine does.  Then
#:                   the families (figures/tables/families.csv): properties
#:                   through tumble.h; fails if one is worse than committed.  On
#:                   all cores (JOBS=1: one at a time); stopped, it goes on
#:   make ledger     each tuned number of lib/, its unit and its reason; and what
#:                   half and double of it do to the errors and the work of
#:                   short scenes: figures/tables/ledger.csv.  Half an hour;
#:                   stopped, it goes on
#:   make drape      cloth and rope on all kinds of things, a line of numbers each
#:   make apart      cloth with and without chapter 12's rules of contact
#:   make strings    what hangs by pins, with and without chapter 12's strings
#:                   (DRAPE='--starts 1 --up-to 40 cube': fewer)
#:   make speed      time against error, module by module: figures/tables/speed.csv
#:   make profile    where a step's time goes, in the three scenes
#:   make queries-exact  hard pairs of bodies against exact truth, 1,000 of each
#:                   of 16 families (QUERIES="SEED PAIRS": others)
#:   make soak       a million steps of the room, stirred (SOAK_STEPS=1000: less)
#:   make lines      how long each module is, and its functions
#:   make bits       do gcc and clang, -O0 and -O3, give the same bits?
#:   make peers      the same work by us and by libccd, ODE and Bullet (make
#:                   deps-peers installs them), each with its errors: the CSVs
#:                   of figures/peers, and its picture
#:   make box3d BOX3D=FOLDER    rooms, piles and joints by us and by Box3D, whose
#:                   sources lie in FOLDER: figures/peers/box3d*.csv
#:   make jolt JOLT=FOLDER      the same, and cloth, by us and by Jolt (both: ten
#:                   minutes; QUICK=1: one, and no table is renewed)
#:   make queries-race GJK=FOLDER JOLT=FOLDER BOX3D=FOLDER    distance, yes or no
#:                   and depth by us and by openGJK, Jolt and Box3D
stale:
	@sh figures/draw/stamp.sh && echo "Every figure and table is as its program would make it now." || true
figures:
	$(Q)older="$(if $(ALL),$(FIGURES:%=figure-%) moving,$$(sh figures/draw/stamp.sh -n | grep '^figure-\|^moving$$'))"; \
	  for f in $$older; do $(AGAIN) $$f || exit 1; done
	$(Q)for f in $$(sh figures/draw/stamp.sh -n | grep '^chart-'); do $(AGAIN) $$f || exit 1; done
	$(Q)$(AGAIN) tables
.PHONY: moving stale tables
moving: $(BUILD)/figures/moving need-moving
	@echo "  draw  figures/moving/moving.webp"
	$(Q)sh figures/moving/moving.sh $< figures/moving/moving.webp
	$(Q)for s in room cloth-on-cube cloth-on-rope; do sh figures/moving/moving.sh $< figures/moving/$$s.webp $$s 60 || exit 1; done
	$(Q)sh figures/moving/moving.sh $< figures/moving/moving-dark.webp '' 60
	$(Q)for s in room cloth-on-cube cloth-on-rope; do sh figures/moving/moving.sh $< figures/moving/$$s-dark.webp $$s 60 || exit 1; done
$(CHAPTERS:%=figure-%) $(FIGURES:%=figure-%) speed profile: need-charts $(BUILD)/shrink
$(CHAPTERS:%=figure-%): need-charts
	$(Q)$(foreach f,$(FIGURES_$(@:figure-%=%)),$(call draw,$f,$(call room,$f)) &&) true
$(FIGURES:%=figure-%): figure-%: need-charts $(BUILD)/figures/%
	$(Q)$(call draw,$*,$(call room,$*))

CHARTS := $(basename $(notdir $(wildcard figures/[0-9]*/*.gp figures/peers/*.gp)))
data = $(patsubst %/piles.csv,%/piles-curves.csv,$(1:.gp=.csv))
redraw = $(foreach f,$(wildcard figures/*/$1.gp),$(call chart,$1,$(call data,$f),$(f:.gp=.svg)))
.PHONY: charts $(CHARTS:%=chart-%)
charts: need-charts
	$(Q)$(foreach f,$(CHARTS),$(call redraw,$f) &&) sh figures/draw/stamp.sh -d $(CHARTS)
$(CHARTS:%=chart-%): chart-%: need-charts
	$(Q)$(call redraw,$*) && sh figures/draw/stamp.sh -d $*

hard: $(BUILD)/hard $(BUILD)/hard-plain $(BUILD)/families $(BUILD)/tumble-sweep
	$(Q)sh tests/hard/hard.sh $(BUILD) figures/tables $(JOBS); short=$$?; [ $$short -gt 1 ] || \
	  $(STAMP) $(notdir $(basename $(wildcard figures/tables/hard*.csv figures/tables/families.csv))) && exit $$short

# Compiled to count the blocks of code that it runs, which is the work of a scene.
IN_BLOCKS := -O1 -fsanitize-coverage=trace-pc
.PHONY: ledger
ledger:
	$(Q)$(AGAIN) BUILD=$(BUILD)/ledger CFLAGS='$(IN_BLOCKS)' $(BUILD)/ledger/battery
	$(Q)CC='$(CC)' SETTINGS='$(EXACT) $(IN_BLOCKS) $(SHARED)' sh tests/ledger/ledger.sh $(BUILD)/ledger > $(BUILD)/ledger.csv
	$(Q)cp $(BUILD)/ledger.csv figures/tables/ledger.csv && $(STAMP) ledger

.PHONY: drape apart strings
drape: $(BUILD)/drape
	$(Q)$(BUILD)/drape $(DRAPE)
# Chapter 12's rules of contact and strand, and what comes without them.
APART = --substeps 4 --starts 3 --from 40 --up-to 40
apart: $(BUILD)/drape $(BUILD)/drape-apart
	$(Q)echo 'all rules:' && $(BUILD)/drape $(APART) 27 ball pole
	$(Q)echo 'contacts apart, strands last:' && $(BUILD)/drape-apart $(APART) 27 ball pole
	$(Q)echo 'and contacts once more:' && AGAIN=1 $(BUILD)/drape-apart $(APART) 27 ball pole
# What hangs by pins, with chapter 12's strings and by the links alone.
strings: $(BUILD)/drape $(BUILD)/drape-links
	$(Q)echo 'with strings:' && $(BUILD)/drape 31
	$(Q)echo 'links alone:' && $(BUILD)/drape-links 31

# The figures that set time against error, in the book's order; others do it in
# passing.  What they say in a line is gathered in a table.
SPEED := 21-verlet 21-constraint 21-body 10-fewer 21-hit_face \
  06-tree 21-sphere_tree 07-response 08-orders \
  13-blocks 13-bodies 21-world
.PHONY: speed profile
speed: need-charts $(SPEED:%=$(BUILD)/figures/%)
	$(Q)$(foreach f,$(SPEED),$(call draw,$f,$(call room,$f)) &&) true
	$(Q)$(AGAIN) tables
profile: $(BUILD)/figures/21-profile
	$(Q)$(call draw,21-profile,figures/21)
	$(Q)$(AGAIN) tables
# What these measured, and other figures in passing, as two tables.
tables:
	$(Q)awk -f figures/draw/table.awk -v csv=figures/tables/speed.csv \
	  -v machine=figures/tables/machine.csv \
	  -v head='module,what,at this error,best,beside,takes times as long' \
	  $(foreach f,$(SPEED),$(call room,$f)/$f.csv)
	$(Q)awk -f figures/draw/table.awk -v csv=figures/tables/profile.csv \
	  -v head='phase,room,cloth on a cube,cloth on a rope' figures/21/21-profile.csv
	$(Q)$(STAMP) speed profile

SOAK_STEPS ?= 1000000
.PHONY: soak queries-exact
queries-exact: $(BUILD)/queries-exact
	$(Q)$(BUILD)/queries-exact $(QUERIES)
soak: $(BUILD)/soak
	$(Q)$(BUILD)/soak $(SOAK_STEPS)

# Are the others' headers there?  Bullet is C++, so its file is.
BULLET := -isystem /usr/include/bullet
peers_here = printf '\043include <%s>\n' ccd/ccd.h ode/ode.h \
  btBulletDynamicsCommon.h | $(CXX) -E $(BULLET) -x c++ - > /dev/null 2>&1
.PHONY: peers theirs
peers:
	@$(peers_here) || { echo "make peers measures libccd, ODE and Bullet, which\
	 are not installed: make deps-peers installs them." >&2; exit 1; }
	$(Q)$(AGAIN) $(BUILD)/peers $(BUILD)/piles
	$(Q)$(BUILD)/peers > figures/peers/peers.csv.new
	$(Q)mv figures/peers/peers.csv.new figures/peers/peers.csv && $(STAMP) peers
	$(Q)$(BUILD)/piles > figures/peers/piles-curves.csv.new
	$(Q)mv figures/peers/piles-curves.csv.new figures/peers/piles-curves.csv
	$(Q)$(AGAIN) piles-picture
# The table and the picture of what was measured.
.PHONY: piles-picture
piles-picture:
	$(Q)awk -f figures/draw/table.awk -v csv=figures/peers/piles.csv \
	  -v head='scene,by,a step,overlap,moved,crept from 5 s on,asleep at,with sleeping' \
	  figures/peers/piles-curves.csv
	$(Q)$(AGAIN) chart-piles && $(STAMP) piles

# Box3D and Jolt are in no package, so their sources are built here, as they come
# but for a library that is small and has no checks.  QUICK=1: two short throws.
THROWS ?= 20
FOR_BOX3D := -DCMAKE_BUILD_TYPE=Release -DBOX3D_SAMPLES=OFF -DBOX3D_UNIT_TESTS=OFF \
  -DBOX3D_BENCHMARKS=OFF -DBOX3D_VALIDATE=OFF
FOR_JOLT := -DCMAKE_BUILD_TYPE=Distribution -DTARGET_UNIT_TESTS=OFF -DTARGET_HELLO_WORLD=OFF \
  -DTARGET_PERFORMANCE_TEST=OFF -DTARGET_SAMPLES=OFF -DTARGET_VIEWER=OFF -DINTERPROCEDURAL_OPTIMIZATION=OFF
BOX3D_MADE ?= $(BUILD)/box3d-made
JOLT_MADE ?= $(BUILD)/jolt-made
RACES := $(if $(QUICK),$(BUILD)/races,figures/peers)
# 1: box3d or jolt; 2: the folder of its sources; 3: of what cmake reads there; 4:
# its options; 5: where it is built.
define raced
	$(Q)mkdir -p $(BUILD) && cmake -S '$3' -B '$5' $4 > $(BUILD)/$1.log \
	  && cmake --build '$5' >> $(BUILD)/$1.log
	$(Q)$(AGAIN) $(BUILD)/$1
	$(Q)mkdir -p $(BUILD)/races && $(BUILD)/$1 $(BUILD)/races $(if $(QUICK),0,$(THROWS)) > $(BUILD)/races/$1.txt
	$(Q)awk -f figures/draw/table.awk -v csv=$(BUILD)/races/none -v machine=$(BUILD)/races/$1-machine.csv \
	  $(BUILD)/races/$1.txt > /dev/null
	$(Q)commit=$$(git -C '$2' rev-parse --short HEAD) && sed -i "1s/$$/,commit of $1/; 2s/$$/,$$commit/" \
	  $(BUILD)/races/$1-machine.csv
	$(Q)[ $(RACES) = $(BUILD)/races ] || cp $(BUILD)/races/$1*.csv $(RACES)
	$(Q)$(if $(QUICK),,$(STAMP) $1)
	@for t in $(RACES)/$1*.csv; do column -s, -t $$t; done
endef
.PHONY: box3d jolt
box3d:
	@[ -f '$(BOX3D)/include/box3d/box3d.h' ] && command -v cmake > /dev/null || { echo "make box3d BOX3D=FOLDER\
	 wants cmake, and Box3D's sources in FOLDER (the book's numbers are of commit 30c67b5)." >&2; exit 1; }
	$(call raced,box3d,$(BOX3D),$(BOX3D),$(FOR_BOX3D),$(BOX3D_MADE))
jolt:
	@[ -f '$(JOLT)/Jolt/Jolt.h' ] && command -v cmake > /dev/null || { echo "make jolt JOLT=FOLDER\
	 wants cmake, and Jolt's sources in FOLDER (the book's numbers are of commit 3b47ec39)." >&2; exit 1; }
	$(call raced,jolt,$(JOLT),$(JOLT)/Build,$(FOR_JOLT),$(JOLT_MADE))

# Each of GJK, JOLT and BOX3D is optional: whose folder is not given is not asked.
.PHONY: queries-race
queries-race:
	$(Q)mkdir -p $(BUILD)
	$(Q)[ -z '$(BOX3D)' ] || { cmake -S '$(BOX3D)' -B $(BOX3D_MADE) -DCMAKE_BUILD_TYPE=Release -DBOX3D_SAMPLES=OFF \
	  -DBOX3D_UNIT_TESTS=OFF -DBOX3D_BENCHMARKS=OFF > $(BUILD)/queries.log && cmake --build $(BOX3D_MADE) >> $(BUILD)/queries.log 2>&1; }
	$(Q)rm -f $(BUILD)/figures/queries.o
	$(Q)$(AGAIN) $(BUILD)/queries
	$(Q)$(BUILD)/queries > figures/peers/queries.csv.new
	$(Q)mv figures/peers/queries.csv.new figures/peers/queries.csv && $(STAMP) queries

# Without asserts: what no program may do is a branch that no test can take.
coverage:
	$(Q)rm -rf $(BUILD)/coverage
	$(Q)$(AGAIN) checks library BUILD=$(BUILD)/coverage \
	  CFLAGS='-O0 -g --coverage -DNDEBUG'
	$(Q)sh tests/script/run.sh $(TESTS:%=$(BUILD)/coverage/tests/%)
	$(Q)gcov -b -n $(BUILD)/coverage/*/*.gcno 2>/dev/null | awk -f tests/script/coverage.awk

lines:
	@awk -f tests/script/lines.awk Makefile lib/tumble.h lib/*/*.h lib/*/*.c | column -s, -t

bits: need-clang
	$(Q)sh tests/script/bits.sh '$(AGAIN)' $(BUILD)/compare

#:
#: Be strict
#:   make sanitize   the tests under the address and undefined sanitizers
#:   make valgrind   the tests under valgrind
#:   make test-site  live figures in a real browser: bits, dials at all corners, a
#:                   walk at random (SEED=N repeats it); exercises written in
#:                   the page, two wrong answers of each (WRONGS=0: all); and each
#:                   page, as on a slow phone: errors, links, keys, contrast, load
#:   make fuzz       any bytes for obj, the queries and the options, and random
#:                   worlds of any seed, 60 s each
#:   make strict     every warning of gcc and of clang is an error
#:   make clean      remove build/
#:
#: make deps-book adds pandoc and img2webp; make deps-site adds what makes and
#: tests the live figures: clang for WebAssembly, node, npm and chromium; make
#: deps-dev adds clang, its fuzzer, valgrind, cmake, and GNU Parallel, which
#: build/tumble --sweep and make hard need.
#: NATIVE=1 builds for this very machine.  V=1 shows the commands.
#: FUZZ_SECONDS=600 fuzzes for longer.
sanitize: need-check
	$(Q)$(AGAIN) checks BUILD=$(BUILD)/sanitize \
	  CFLAGS='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all'
	$(Q)CK_TIMEOUT_MULTIPLIER=5 sh tests/script/run.sh $(TESTS:%=$(BUILD)/sanitize/tests/%)

valgrind: need-check need-valgrind checks
	$(Q)CK_TIMEOUT_MULTIPLIER=20 RUN='valgrind -q --leak-check=full --error-exitcode=3' \
	  sh tests/script/run.sh $(CHECKS)

FUZZ_SECONDS ?= 60
fuzz: need-fuzz
	$(Q)$(AGAIN) fuzzers CC=clang BUILD=$(BUILD)/fuzz \
	  CFLAGS='-O1 -g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all'
	$(Q)sh tests/script/fuzz.sh $(BUILD)/fuzz $(FUZZ_SECONDS) $(FUZZERS)

# To clang NAN is a float, and a judge's long double a mistake.
strict: need-check need-clang
	$(Q)$(AGAIN) -k objects CC=gcc BUILD=$(BUILD)/strict-gcc \
	  CFLAGS='-O2 -Werror -Wlogical-op -Wduplicated-cond -Wduplicated-branches'
	$(Q)$(AGAIN) -k objects CC=clang BUILD=$(BUILD)/strict-clang CFLAGS='-O2 -Werror' \
	  WARNINGS='$(filter-out -Wdouble-promotion,$(WARNINGS))'
	$(Q)! $(peers_here) || $(AGAIN) -k theirs BUILD=$(BUILD)/strict-theirs \
	  CFLAGS='-O2 -Werror'
	@echo "strict: gcc and clang have nothing to say"

clean:
	$(Q)rm -rf build

# --- How things are made --------------------------------------------------------
checks: $(CHECKS) $(BUILD)/tumble $(BUILD)/bits $(BUILD)/scenes $(ALONE:%=$(BUILD)/%) $$(LIVE_PROGRAMS)
fuzzers: $(FUZZERS:%=$(BUILD)/tests/%)
objects: $(ALL) \
  $(patsubst %.c,$(BUILD)/tests/%.o,$(notdir $(wildcard tests/*/*.c))) \
  $(patsubst %.c,$(BUILD)/figures/%.o,$(filter-out $(THEIRS) box3d_mover.c queries_gjk.c queries_box3d.c $(notdir $(wildcard figures/live/*.c figures/workshop/*.c)),$(notdir $(wildcard figures/*/*.c)))) \
  $(patsubst figures/live/%.c,$(BUILD)/live/%.o,$(filter-out %_wasm.c,$(wildcard figures/live/*.c)))
theirs: $(THEIRS:%.c=$(BUILD)/figures/%.o) $(BUILD)/figures/piles_bullet.o

# A figure with a .gp prints data, which become a chart; one without paints its
# own picture, whose name is its argument.  The book's are shrunk and stamped.
# A stamp says what made it, and with which settings.
STAMP = SETTINGS='$(EXACT) $(CFLAGS)' CC='$(CC)' sh figures/draw/stamp.sh
# Where the book's figure 04-rules stands: figures/04.
room = figures/$(firstword $(subst -, ,$1))
chart = sh figures/draw/chart.sh $(wildcard figures/*/$1.gp) $2 $3
draw = $(if $(wildcard figures/*/$1.gp),echo "  draw  $2/$1.svg" && \
  $(BUILD)/figures/$1 > $2/$1.csv.new && mv $2/$1.csv.new $2/$1.csv && \
  $(call chart,$1,$2/$1.csv,$2/$1.svg),\
  echo "  draw  $2/$1.png" && $(BUILD)/figures/$1 $2/$1.png)$(if $(filter figures/%,$2), && \
  $(if $(wildcard figures/*/$1.gp),,$(BUILD)/shrink $2/$1.png && sh figures/draw/dark.sh $(BUILD)/figures/$1 $2/$1.png &&) $(STAMP) $1)

# These count the memory of what they test, and refuse it.
SCARCE := $(addprefix $(BUILD)/tests/check_,status verlet mesh body \
  rigidity convex hull capsule obj sphere sphere_tree grid ordering \
  line rigid4 solver broad pairs cache sleep world come_and_go step measure world_scene scene experiments system \
  thread tumble_save given terrain)
$(SCARCE): LDFLAGS += -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=aligned_alloc,--wrap=free
$(SCARCE): $(BUILD)/tests/scarce.o

# This one reads tables of a saved world as garbage.
$(BUILD)/tests/check_tumble_save: LDFLAGS += -Wl,--wrap=store_table

# This one has the plain form of four numbers beside the other.
$(BUILD)/tests/check_real4: $(BUILD)/tests/real4_plain.o $(BUILD)/tests/real4_wide.o
# The plain contact solver, which judges the fast one and draws figures.
$(BUILD)/tests/check_solver $(patsubst %,$(BUILD)/figures/%,$(filter 13-%,$(FIGURES))): \
  $(BUILD)/tests/plain_solver.o

# The plain way out of a floor.
$(BUILD)/tests/check_seams $(BUILD)/figures/11-seams: $(BUILD)/tests/plain_seam.o
# The plain impact, which judges those in time.
$(BUILD)/tests/check_restitution $(BUILD)/figures/15-impact: $(BUILD)/tests/plain_impact.o
# And the plain blow.
$(BUILD)/tests/check_blow: $(BUILD)/tests/plain_blow.o

# And the plain strand.
$(BUILD)/tests/check_line $(BUILD)/figures/12-hold: $(BUILD)/tests/plain_strand.o

# This one looks at pictures.
$(BUILD)/tests/check_painter: CHECK_LIBS += -lpng
$(BUILD)/tests/check_painter: $(BUILD)/libpainter.a

# These look at how the figures of chapter 21 count time, and at their threads,
# which can be refused.
$(addprefix $(BUILD)/tests/check_,clock thread tumble_save): $(BUILD)/libpainter.a
$(BUILD)/tests/check_thread: LDFLAGS += -Wl,--wrap=pthread_create

# These ask the slow oracle about bodies made for the purpose.
ASKS := $(addprefix $(BUILD)/tests/check_,oracle gjk hit_face query swept) $(addprefix $(BUILD)/figures/,04-rules 05-rules 10-slow)
$(ASKS): $(BUILD)/tests/oracle.o $(BUILD)/tests/bodies.o
# These only make them.
$(addprefix $(BUILD)/tests/check_,support exact nearest climb search): $(BUILD)/tests/bodies.o

# Figures that change a module, one change at a time: build/rules/05-rules-1.o is
# lib/paper/hit_face.c with the first change of figures/05/05-rules.edits, and
# its functions, those named here, end in _1.
define variants
$(BUILD)/figures/$1: $(patsubst %,$(BUILD)/rules/$1-%.o,$(shell awk '/^wrong/ { print ++n }' $(wildcard figures/*/$1.edits)))
$(BUILD)/rules/$1-%.c: $(wildcard figures/*/$1.edits) lib/paper/$2.c exercises/wrong.awk
	$(Q)mkdir -p $$(@D)
	$(Q)awk -v want=$$* -f exercises/wrong.awk $$< lib/paper/$2.c > $$@
$(BUILD)/rules/$1-%.o: CPPFLAGS += $(foreach f,$3,-D$f=$f_$$*)
$(BUILD)/rules/$1-%.o: $(BUILD)/rules/$1-%.c $(BUILD)/flags
	$$(compile)
endef
GJK_NAMES := triangle_nearest_wide gjk_distance gjk_search hull_support hull_in_range triangle_normal triangle_weigh
$(eval $(call variants,04-rules,gjk,$(GJK_NAMES)))
$(eval $(call variants,04-distance,gjk,$(GJK_NAMES)))
$(eval $(call variants,05-rules,hit_face,hit_face_find hit_face_climb))
$(eval $(call variants,05-bounds,hit_face,hit_face_find hit_face_climb))

# This one counts triangles that cross.
$(BUILD)/tests/check_crossings: $(BUILD)/tests/crossings.o

# These judge where the bodies of a scene lie.
$(addprefix $(BUILD)/tests/check_,poses system): $(BUILD)/tests/poses.o
# The scenes of the paper's experiments.
$(addprefix $(BUILD)/tests/check_,experiments system world_scene) $(BUILD)/bits $(BUILD)/soak $(BUILD)/peers: \
  $(BUILD)/tests/experiments.o

# The hard cases: a program that runs them all, and the tests of the fast ones.
HARD := $(patsubst %.c,$(BUILD)/tests/%.o,$(notdir $(wildcard tests/hard/hard_*.c))) \
  $(addprefix $(BUILD)/tests/,oracle.o poses.o experiments.o bodies.o crossings.o)
$(BUILD)/tests/hard.o: CPPFLAGS += -DFLAGS='"$(EXACT) $(CFLAGS)"'
$(addprefix $(BUILD)/tests/check_,hard judge): $(HARD)
$(BUILD)/hard-plain: $(BUILD)/tests/plain.o $(HARD) $(ALL)
	$(call link,-lm)
$(BUILD)/hard: $(BUILD)/tests/hard.o $(HARD) $(ALL)
	$(call link,-lm)
# Families see of the library what a program sees, and nothing else.
FAMILY := $(patsubst %.c,$(BUILD)/tests/%.o,families.c $(notdir $(wildcard tests/hard/family*.c))) \
  $(addprefix $(BUILD)/tests/,hard_report.o crossings.o)
$(BUILD)/families: $(BUILD)/tests/hard.o $(FAMILY) $(BUILD)/seen.a
	$(call link,-lm)
$(BUILD)/tests/check_families: $(FAMILY)
# What the ledger runs.
$(BUILD)/battery: $(patsubst %.c,$(BUILD)/tests/%.o,$(notdir $(wildcard tests/ledger/*.c))) \
  $(SCENES:%.c=$(BUILD)/figures/%.o) $(ALL)
	$(call link,-lm)
$(BUILD)/drape-apart: LDFLAGS += -Wl,--wrap=lines_relax,--wrap=soft_relax,--wrap=soft_hold
$(BUILD)/drape-apart: $(BUILD)/tests/apart.o
$(BUILD)/drape-links: LDFLAGS += -Wl,--wrap=taut_most
$(BUILD)/drape-links: $(BUILD)/tests/no_strings.o
$(BUILD)/drape $(BUILD)/drape-apart $(BUILD)/drape-links: $(BUILD)/tests/drape.o $(HARD) $(ALL)
	$(call link,-lm)
$(BUILD)/tests/check_certificate: $(BUILD)/tests/crossings.o
# The plain proof, which judges the certificate.
$(BUILD)/tests/check_certificate $(BUILD)/figures/16-plain: $(BUILD)/tests/plain_proof.o
$(BUILD)/tests/check_given: $(BUILD)/tests/crossings.o
$(BUILD)/tests/check_soft_world: $(BUILD)/tests/crossings.o
# Pairs of hard families against exact truth: many, and a few as a test.
EXACTLY := $(addprefix $(BUILD)/tests/,exact_judge.o made_pairs.o truth.o)
$(BUILD)/tests/check_exact_pairs: $(EXACTLY)
$(BUILD)/queries-exact: $(BUILD)/tests/exact.o $(EXACTLY) $(ALL)
	$(call link,-lm)
$(BUILD)/soak: $(BUILD)/tests/soak.o $(ALL)
	$(call link,-lm)

# A test sees the line up to its module; a test of no module sees all of it.
$(BUILD)/tests/check_%: $(BUILD)/tests/check_%.o $$(if $$(filter $$*,$(MODULES) poses experiments),$$(UPTO_$$*),$(ALL))
	$(call link,$(CHECK_LIBS))

# So does a fuzzer, which is called by libFuzzer.  One has a file system of
# its own, two make bodies and look at the answers from outside.
$(BUILD)/tests/fuzz_%: $(BUILD)/tests/fuzz_%.o $$(if $$(filter $$*,$(MODULES)),$$(UPTO_$$*),$(ALL) $(BUILD)/libpainter.a)
	$(call link,-fsanitize=fuzzer -lm)
$(BUILD)/tests/fuzz_obj: LDFLAGS += -Wl,--wrap=fopen
$(addprefix $(BUILD)/tests/fuzz_,gjk hit_face): \
  $(addprefix $(BUILD)/tests/,sets.o oracle.o bodies.o)

# A random world takes no bytes but a number, so its fuzzer is a plain program:
# make build/tests/fuzz_world.
$(BUILD)/tests/check_worlds: $(BUILD)/tests/worlds.o
$(BUILD)/tests/fuzz_world: $(addprefix $(BUILD)/tests/,fuzz_world.o worlds.o) $(ALL)
	$(call link,-lm)

# A figure sees the line up to its chapter, and what it asks of the painter;
# those of chapter 20 draw what the hard cases measure.
$(patsubst %,$(BUILD)/figures/%,$(filter 20-%,$(FIGURES))): $(BUILD)/tests/hard_set.o
$(BUILD)/figures/%: $(BUILD)/figures/%.o $$(call FLOOR,$$(firstword $$(subst -, ,$$*))) $(BUILD)/libpainter.a
	$(call link,-lpng -lm)

# What sees of the library what a program sees.
$(BUILD)/scenes: $(BUILD)/figures/example_main.o $(SCENES:%.c=$(BUILD)/figures/%.o) $(BUILD)/seen.a
	$(call link,-lm)
$(ALONE:%=$(BUILD)/%): $(BUILD)/%: $(BUILD)/figures/%.o $(BUILD)/seen.a
	$(call link,-lm -lpthread)

$(BUILD)/shrink: $(BUILD)/figures/shrink.o $(BUILD)/lib/status.o $(BUILD)/libpainter.a
	$(call link,-lpng -lm)

$(BUILD)/paint-little: $(BUILD)/figures/paint_little.o $(BUILD)/lib/status.o $(BUILD)/libpainter.a
	$(call link,-lpng -lm)

$(BUILD)/tumble: $(BUILD)/figures/main.o $(ALL) $(BUILD)/libpainter.a | $(BUILD)/tumble-sweep
	$(call link,-lpng -lm)
# It becomes this script for a sweep.
$(BUILD)/tumble-sweep: figures/command/sweep.sh
	$(Q)mkdir -p $(@D)
	$(Q)install -m 755 $< $@

# libccd and ODE are what their packages built, with -O2.
$(BUILD)/figures/peers_ccd.o: CFLAGS += -O2
$(BUILD)/peers: $(PEERS:%.c=$(BUILD)/figures/%.o) $(BUILD)/figures/clock.o \
  $(addprefix $(BUILD)/tests/,oracle.o bodies.o hard_set.o) $(ALL)
	$(call link,-lode -lccd -lm)

$(BUILD)/figures/piles_bullet.o: figures/peers/piles_bullet.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	@echo "  c++   $<"
	$(Q)$(CXX) -std=c++11 $(CFLAGS) -Wall -Wextra $(ROOMS) $(BULLET) -MMD -MP -c $< -o $@
$(BUILD)/piles: $(PILES:%=$(BUILD)/figures/%.o) $(BUILD)/figures/clock.o \
  $(BUILD)/tests/oracle.o $(ALL)
	@echo "  link  $@"
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) $^ -lode -lccd -lBulletDynamics -lBulletCollision -lLinearMath -lm -o $@

# openGJK in doubles, as it is; of Jolt the headers alone, for the instructions that its own build takes.
RACERS := $(if $(GJK),gjk) $(if $(BOX3D),box3d) $(if $(JOLT),jolt)
$(BUILD)/figures/queries.o: CPPFLAGS += $(if $(GJK),-DWITH_GJK) $(if $(BOX3D),-DWITH_BOX3D) $(if $(JOLT),-DWITH_JOLT)
$(BUILD)/figures/queries_gjk.o: CPPFLAGS += -isystem $(GJK)/scalar/include
$(BUILD)/figures/queries_box3d.o: CPPFLAGS += -isystem $(BOX3D)/include
$(BUILD)/figures/queries_jolt.o: figures/peers/queries_jolt.cpp figures/peers/queries.h
	@mkdir -p $(@D)
	@echo "  c++   $<"
	$(Q)$(CXX) -std=c++17 -O3 -DNDEBUG -mavx2 -mfma -mbmi -mlzcnt -mf16c -mpopcnt -isystem $(JOLT) -c $< -o $@
$(BUILD)/figures/openGJK.o: $(GJK)/scalar/openGJK.c
	@mkdir -p $(@D)
	$(Q)$(CC) -O3 -DNDEBUG -I$(GJK)/scalar/include -c $< -o $@
$(BUILD)/queries: $(patsubst %,$(BUILD)/figures/%.o,queries ball clock $(RACERS:%=queries_%) $(if $(GJK),openGJK)) \
  $(BUILD)/tests/oracle.o $(ALL)
	@echo "  link  $@"
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) $^ $(if $(BOX3D),$(BOX3D_MADE)/src/libbox3d.a) -lm -o $@

RACE := $(patsubst %,$(BUILD)/figures/%.o,race_run race_scenes race_judge race_tumble clock) \
  $(BUILD)/tests/oracle.o $(BUILD)/tests/crossings.o $(BUILD)/seen.a
$(BUILD)/figures/box3d_mover.o: CPPFLAGS += -isystem $(BOX3D)/include
$(BUILD)/box3d: $(patsubst %,$(BUILD)/figures/%.o,box3d box3d_mover) $(RACE)
	$(call link,$(BOX3D_MADE)/src/libbox3d.a -lpthread -lm)

# What Jolt's library was built for, its headers have to know.
JOLT_FLAGS = $(filter-out -Werror,$(shell sed -n 's/^CXX_[DF][EL][A-Z]* = //p' $(JOLT_MADE)/CMakeFiles/Jolt.dir/flags.make))
$(BUILD)/figures/jolt_mover.o: figures/peers/jolt_mover.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	@echo "  c++   $<"
	$(Q)$(CXX) $(JOLT_FLAGS) -Wextra $(ROOMS) -isystem '$(JOLT)' -MMD -MP -c $< -o $@
$(BUILD)/jolt: $(patsubst %,$(BUILD)/figures/%.o,jolt jolt_mover) $(RACE)
	@echo "  link  $@"
	$(Q)$(CXX) $(CFLAGS) $(LDFLAGS) $^ $(JOLT_MADE)/libJolt.a -lpthread -lm -o $@

$(BUILD)/bits: $(BUILD)/tests/bits.o $(BUILD)/figures/thread.o $(ALL)
	$(call link,-lm)

define link
	@echo "  link  $@"
	$(Q)$(CC) $(CFLAGS) $(LDFLAGS) $^ $1 -o $@
endef

$(BUILD)/libtumble.a: $(ALL)
$(BUILD)/libpainter.a: $(PAINTER:%.c=$(BUILD)/figures/%.o) $(addprefix $(BUILD)/tests/,poses.o experiments.o)
$(BUILD)/lib%.a:
	@echo "  pack  $@"
	$(Q)rm -f $@ && $(AR) rcs $@ $^

# All modules as one object in which only tumble_* is seen from outside.  The
# compiler knows the linker, and the objcopy, of what it compiles for; asked to
# sanitize, clang would put all of its library in.  32 bits share their thunks.
# Where objects are not ELF, the one file is compiled, in which all else is static.
OBJCOPY ?= $(shell $(CC) -print-prog-name=objcopy)
hide = $(CC) $(filter-out -fsanitize%,$(CFLAGS)) -r -nostdlib $1 -o $2 && $(OBJCOPY) --wildcard \
  --keep-global-symbol='tumble_*' --keep-global-symbol='__x86.*' $2
$(BUILD)/seen.o: $$(if $$(ELF),$$(ALL),$(BUILD)/tumble.c $(BUILD)/tumble.h $(BUILD)/flags)
	@echo "  pack  $@"
	$(Q)$(if $(ELF),$(call hide,$(filter %.o,$^),$@),$(CC) $(EXACT) $(CFLAGS) -c $< -o $@)
$(BUILD)/seen.a: $(BUILD)/seen.o
	$(Q)rm -f $@ && $(AR) rcs $@ $^
$(BUILD)/seen.so: $(BUILD)/seen.o
	$(Q)$(CC) $(CFLAGS) -shared -Wl,-soname,libtumble.so.$(MAJOR) $^ -lm -o $@

# -MMD writes beside each object which headers it read.
define compile
	@mkdir -p $(@D)
	@echo "  cc    $<"
	$(Q)$(COMPILE) $(ROOMS) $(CPPFLAGS) -MMD -MP -c $< -o $@
endef
$(BUILD)/figures/%.o: CPPFLAGS += -DFLAGS='"$(EXACT) $(CFLAGS)"'
# Folders show what belongs together; what is built of them lies side by side.
ROOMS := -Ilib $(patsubst %/,-I%,$(wildcard lib/*/ tests/support/ tests/contact/ tests/soft/ tests/hard/ tests/fuzz/ tests/ledger/ \
  figures/draw/ figures/measure/ figures/command/ figures/scenes/ figures/peers/ figures/live/))
# What a program is linked with may be an archive or a shared library: one form of an
# object does for both, and is the same code as without.
SHARED := -fPIC -fvisibility=hidden
$(sort $(OURS)/lib/%.o $(BUILD)/lib/%.o): CPPFLAGS += $(SHARED)
$(OURS)/lib/%.o: $$(or $$(wildcard lib/*/$$*.c),lib/*/$$*.c) $(OURS)/flags
	$(compile)
$(OURS)/tests/%.o: $$(or $$(wildcard tests/*/$$*.c),tests/*/$$*.c) $(OURS)/flags
	$(compile)
# The time of a test passes in lib/, so its own file is compiled for a debugger, in
# less than half the time, but not where what it tests is all in a header.
ifneq ($(filter -O3,$(CFLAGS)),)
$(patsubst %,$(OURS)/tests/%.o,$(filter-out check_vec3 check_real4 check_task,$(TESTS))): CPPFLAGS += -Og
endif
$(OURS)/figures/%.o: $$(or $$(wildcard figures/*/$$*.c),figures/*/$$*.c) $(OURS)/flags
	$(compile)
$(OURS)/%.o: %.c $(OURS)/flags
	$(compile)
$(OURS)/%.d: ;
# A source that has moved is still named by what was built of it: that is built
# again, and not missed.
lib/%.c tests/%.c figures/%.c: ;
-include $(wildcard $(OURS)/*/*.d $(OURS)/*/*/*.d)

include figures/live/live.mk
include figures/workshop/workshop.mk
include chapters/site/site.mk

# Changes when the compiler or its flags do, and then everything is rebuilt.
$(sort $(BUILD)/flags $(OURS)/flags): FORCE
	@mkdir -p $(@D) 2> /dev/null && [ -w $(@D) ] || { echo "$(@D) cannot be written:\
	 is this folder yours?  BUILD=FOLDER builds elsewhere." >&2; exit 1; }
	@echo '$(strip $(COMPILE) $(SHARED))' | cmp -s - $@ || echo '$(strip $(COMPILE) $(SHARED))' > $@
