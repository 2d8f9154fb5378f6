-- page.lua - what pandoc needs to be told to make a page of a chapter: pictures and
-- code with captions, links wherever something of the book is named.
--
--   --metadata page=04-gjk     the page that is read
--   --metadata whole=true      all pages as one: a link leads to an anchor
--   --metadata volume=1        those of a volume: what is in the other has a number there

local here = 'chapters/site/'
local names = dofile(here .. 'names.lua')
local size = dofile(here .. 'size.lua')
local code = dofile(here .. 'code.lua')
local formula = dofile(here .. 'formula.lua')
local anchor = dofile(here .. 'headings.lua')

local FOLD = 32             -- lines of code that lie open; more are unfolded by the reader
local page, whole           -- the page's name; are all pages one?
local volume                -- on paper: 1 are the chapters, 2 the listings
local exercises = {}        -- NN/name
local written               -- the exercise that is written in this page
local seen = 0              -- small figures so far
local taken                 -- the anchors that stand already
for folder in io.popen('ls exercises'):lines() do
  local number, name = folder:match('^(%d%d%l?)%-(.*)')
  if number then exercises[number .. '/' .. name] = true end
end

local function raw(html) return pandoc.RawInline('html', html) end
local function block(html) return pandoc.RawBlock('html', html) end
local function html_of(inlines)
  return pandoc.write(pandoc.Pandoc({ pandoc.Plain(inlines) }), 'html', { html_math_method = 'mathml' })
end

-- --- where a link leads -----------------------------------------------------------

-- An element of a page, or with no id the page.
local function place(other, id)
  if volume and volume ~= (other:match('^%d') and '1' or '2') then return nil end
  if whole then return '#' .. (id and id ~= '' and id or other) end
  local file = other == page and id and id ~= '' and '' or other .. '.html'
  return file .. (id and id ~= '' and '#' .. id or '')
end
local function place_of_chapter(number)
  local chapter = names.chapter[number]
  if chapter and chapter.page ~= page then return place(chapter.page) end
end
-- One that can be written in the page has a page of its own (workshop.mk).
local workshop = io.open((os.getenv('BUILD') or 'build') .. '/workshop/node/.done')
local function place_of_exercise(name)
  if not exercises[name] or whole then return nil end
  local id = name:gsub('/', '-')
  if id == written then return nil end
  return workshop and id:match('^0') and 'write-' .. id .. '.html' or 'exercises.html#' .. id
end
-- A word such as `build` may be a helper of one file, and plain English in another
-- chapter: without an underscore it leads away only if a header declares it.
local function place_of_code(name)
  local other, file = names.place(name, page)
  local is_plain = other ~= page and not name:match('_') and file and file:match('%.c$')
  if other and not is_plain then return place(other, names.id(name, file)) end
end
local function place_of_figure(name)
  if names.figure[name] then return place(names.figure[name], 'figure-' .. name) end
end
-- A file of the tree: its own page, with a line.
local function place_of_file(path, line)
  if whole then return nil end
  if path:match('%.[ch]$') then return 'source/' .. path:gsub('/', '-') .. '.html' .. (line and '#L' .. line or '') end
  if path:match('%.csv$') then return path end
  if path:match('^exercises') then return 'exercises.html' end
end

-- The header of an exercise, if only one has that name, or this page is its; or one
-- of the library.
local headers = {}
for file in io.popen('ls lib/*.h lib/*/*.h'):lines() do headers[file:match('[^/]*$')] = file end
for file in io.popen('ls exercises/*/*.h'):lines() do
  local name = file:match('[^/]*$')
  headers[name] = headers[name] and 'two' or file
end
local function place_of_header(name)
  local own = written and 'exercises/' .. written .. '/' .. name
  local file = own and io.open(own) and own or headers[name]
  return file and file ~= 'two' and place_of_file(file)
end

-- What the words between backticks mean, if the book tells of it.
local function place_of_words(text)
  local figure = text:match('^make figure%-(%d%d%l?%-[%w_-]+)$')
  if figure then return place_of_figure(figure) end
  local exercise = text:match('^make exercise (%d%d%l?/[%w-]+)$') or text:match('^%d%d%l?/[%w-]+$')
  if exercise then return place_of_exercise(exercise) end
  local stage = text:match('^make little$') and '' or text:match('^make little (%d%d%l)$')
  if stage and workshop and not whole and written ~= 'little' then return 'little.html' .. (stage ~= '' and '#' .. stage or '') end
  if text:match('^[%w_]+%.h$') then return place_of_header(text) end
  local name = text:match('^([%a_][%w_]*)%(?%)?$')
  if name and #name > 2 then return place_of_code(name) end
end

-- A link of a woven page.  What stands between its brackets is not looked at again.
local function Link(link)
  local target = link.target
  local path, line = target:match('^%.%./%.%./([^#]*)#?L?(%d*)')
  local other, id = target:match('^([%w_-]+)%.md#?(.*)$')
  -- In the whole book the headings of a page that is no chapter have its name before theirs.
  local near = whole and not page:match('^%d%d%l?%-') and target:match('^#(.*)')
  if near then target = '#' .. page .. '-' .. near end
  if path then target = place_of_file(path, line ~= '' and line)
  elseif other then target = place(other, id) end
  if not path then link.content = { raw(html_of(link.content)) } end
  if not target and other and volume == '1' then return pandoc.Span({ link.content[1], raw('<span class="there" data-page="' .. other .. '"></span>') }) end
  if not target then return pandoc.Span(link.content) end
  return pandoc.Link(link.content, target, link.title, link.attr)
end

-- --- words ------------------------------------------------------------------------

local function link_to(target, content) return target and pandoc.Link(content, target) end

-- A number of a chapter leads there, with the word before it if there is one.
local function link_number(str, word)
  local before, number, after = str.text:match('^(%(?)(%d%d%l?)(%D?.*)$')
  local target = number and place_of_chapter(number)
  if not target then return nil end
  local text = (word and word .. ' ' or '') .. number
  return pandoc.Span({ pandoc.Str(before), pandoc.Link({ pandoc.Str(text) }, target), pandoc.Str(after) })
end
-- "chapter 07", "chapters 07, 08 and 12".
local joins = { ['and'] = true, ['to'] = true, ['or'] = true }
local function number_at(list, i) return list[i] and list[i].t == 'Str' and list[i].text:match('^%d%d') end
local function link_chapters(list)
  for i = #list - 2, 1, -1 do
    local before, word = (list[i].text or ''):match('^(%(?)([Cc]hapters?)$')
    if word and number_at(list, i + 2) then
      local k, comma = i + 2
      repeat
        comma = list[k].text:match('^%d%d%l?,$')
        list[k] = link_number(list[k], k == i + 2 and word) or list[k]
        k = k + (comma and number_at(list, k + 2) and 2 or 4)
      until not number_at(list, k) or not comma and not joins[list[k - 2].text]
      if list[i + 2].t == 'Span' then
        list[i] = pandoc.Str(before)
        list:remove(i + 1)
      end
    end
  end
end

local function link_str(str)
  local before, exercise, after = str.text:match('^(%(?)(%d%d%l?/[%a-]+)(.*)$')
  local target = exercise and place_of_exercise(exercise)
  if target then
    return pandoc.Span({ pandoc.Str(before), pandoc.Link({ pandoc.Str(exercise) }, target), pandoc.Str(after) })
  end
  local doi, rest = str.text:match('^d?o?i?:?(10%.%d%d%d%d+/.-)([%.,:;%)]*)$')
  if doi then return pandoc.Span({ pandoc.Link({ pandoc.Str('doi:' .. doi) }, 'https://doi.org/' .. doi:gsub('<', '%%3C'):gsub('>', '%%3E')), pandoc.Str(rest) }) end
  -- In chapter 23 such numbers are the chapters that explain a word: (04, 13).
  if page == '23-words' and str.text:match('^%(?%d%d%l?[,.;)]*$') then return link_number(str) end
end

-- A comma stays on the line of what a formula ends with, however narrow the page.
local function join(one, two)
  if one.t ~= 'RawInline' or not two.text:match('^[.,:;)]+$') then return { one, two } end
  local before, last = one.text:match('^(.*<wbr/>)(.*)$')
  return { raw((before or '') .. '<span class="joined">' .. (last or one.text) .. two.text .. '</span>') }
end

-- A comma or a bracket stays on the line of the formula or name it belongs to.
local function keep_whole(list)
  local function is_short(inline)
    return inline.t == 'RawInline' or inline.t == 'Code' or inline.t == 'Link' and inline.content[1].t == 'Code'
  end
  for i = #list - 1, 1, -1 do
    local one, two = list[i], list[i + 1]
    if is_short(one) and two.t == 'Str' and two.text:match('^[%p]') or
       one.t == 'Str' and one.text:match('%($') and (is_short(two) or two.classes and two.classes[1] == 'whole') then
      list[i] = pandoc.Span(two.t == 'Str' and join(one, two) or { one, two }, { class = 'whole' })
      list:remove(i + 1)
    end
  end
end

local function Math(math)
  return raw(formula(math.text, math.mathtype == 'DisplayMath', function(tex)
    return html_of({ pandoc.Math('InlineMath', tex) })
  end))
end

local function Inlines(list)
  link_chapters(list)
  for i, inline in ipairs(list) do
    -- A dot between two names stays on the line of the first.
    if inline.t == 'Space' and list[i + 1] and list[i + 1].text == '·' then list[i] = pandoc.Str('\u{a0}') end
    if inline.t == 'Code' then list[i] = link_to(place_of_words(inline.text), { inline }) or inline
    elseif inline.t == 'Str' then list[i] = link_str(inline) or inline end
  end
  keep_whole(list)
  return list
end

-- --- blocks -----------------------------------------------------------------------

-- Code of the book under its caption; each function that the book means when it
-- names it is an anchor.
local function piece_of(caption, piece)
  local file, lines = caption.text:match('^(%S*), lines? ([%d to]*)')
  local ids, files = {}, {}
  for where, line in caption.text:gmatch('(%S+%.%a+), lines? (%d+)') do
    ids[#ids + 1] = where:match('[^/]*$') .. '-L' .. line
    files[where] = true
  end
  local function name(line)
    local word = line:match('^[%a].-([%w_]+)%(') or line:match('^} ([%w_]+);')
    if line:match('^static.*;$') then word = nil end            -- a promise; the function follows
    local _, best = names.place(word or '', page)
    local id = files[best] and names.id(word, best)
    if id and not taken[id] then taken[id] = true; return id end
  end
  local _, count = piece.text:gsub('\n', '\n')
  local html, above = code(piece, name), caption.html
  if count >= FOLD and FORMAT:match('^html') then
    local what = {}
    for some in caption.text:gmatch(': ([^:]*)') do what[#what + 1] = some:gsub(' %S+, lines? .*', '') end
    what = what[1] and table.concat(what, ', ') or 'lines ' .. lines
    above = above:gsub(':[^:>]*</a>', '</a>')
    html = '<details><summary>' .. what .. ' <span>' .. count + 1 .. ' lines</span></summary>' .. html .. '</details>'
  end
  -- A block of several pieces has an anchor for each.
  for k = 2, #ids do above = '<span id="' .. ids[k] .. '"></span>' .. above end
  return block('<figure class="code" id="' .. ids[1] .. '"><figcaption>' .. above .. '</figcaption>' .. html .. '</figure>')
end

-- Columns of numbers stand at the right, and no column has a width of its own.
local function is_column_of_numbers(body, k)
  local any = false
  for _, row in ipairs(body) do
    local cell = row[2] and row[2][k] or row.cells and row.cells[k]
    local text = cell and pandoc.utils.stringify(cell.contents or cell.content) or ''
    if text:match('%d') then any = true end
    if text:match('^%d%d,') or text ~= '' and not text:match('^[%d%s.,+−%%-]*[%a]?[%d%s.,+-]*%%?$') then return false end
  end
  return any
end
-- A number that a program prints with an e is a power of ten.  Where a cell is narrow, a
-- long name goes on after its underscore or its dot.
local raised = { ['-'] = '⁻', ['0'] = '⁰', ['1'] = '¹', ['2'] = '²', ['3'] = '³', ['4'] = '⁴', ['5'] = '⁵', ['6'] = '⁶', ['7'] = '⁷', ['8'] = '⁸', ['9'] = '⁹' }
local cell = {
  Str = function(str)
    local factor, sign, power = str.text:match('^(%d[%d.]*)e([+-])0*(%d+)$')
    if not factor then return nil end
    if power == '0' then return pandoc.Str(factor) end
    return pandoc.Str((factor == '1' and '' or factor .. '·') .. '10' .. ((sign == '-' and sign or '') .. power):gsub('.', raised))
  end,
  Inlines = function(list)           -- a number keeps its unit
    if #list ~= 3 or list[2].t ~= 'Space' or list[1].t ~= 'Str' or not list[1].text:match('^%d[%d.e+-]*$') then return nil end
    return { list[1], pandoc.Str('\u{a0}'), list[3] }
  end,
  Code = function(code)
    if not code.text:match('^[%w_.]+$') or not FORMAT:match('^html') then return nil end
    return raw('<code>' .. code.text:gsub('[_.]', '%0<wbr>') .. '</code>')
  end,
}
local function tidy(table)
  for k, column in ipairs(table.colspecs) do
    local right = table.bodies[1] and is_column_of_numbers(table.bodies[1].body, k)
    table.colspecs[k] = { right and 'AlignRight' or column[1], nil }
  end
  return pandoc.walk_block(table, cell)
end

local function hash_of(name)
  for line in io.lines('tests/bits/bits.txt') do
    local hash = line:match('^live ' .. name .. ' (%S+)')
    if hash then return hash end
  end
end

local function picture_in(para)
  local image = para.t == 'Para' and #para.content == 1 and para.content[1]
  return image and image.t == 'Image' and image
end
local function is_live(para)
  local image = picture_in(para)
  return image and image.src:match('figures/live/') ~= nil
end

-- A picture that stands alone becomes a figure, its text the caption; one of
-- figures/live is what a script sets in motion, with .small its stage alone, with
-- .first at once; one of figures/moving stands still until a script plays it.
local function figure_of(image)
  local path = image.src:gsub('^%.%./%.%./', '')
  local folder, name = path:match('figures/([^/]*)/([^/]*)%.%a+$')
  local wide, high = size(path)
  local shown = path:gsub('%.png$', '.webp')
  local still = folder == 'moving' and path:gsub('%.webp$', '-still.webp')
  if still then shown = still end
  local is_first = image.classes:includes('first')
  local small = folder == 'live' and (is_first or image.classes:includes('small')) and not whole
  local runs = small and image.attributes.race
  local data = runs and ' class="live" data-race="' .. name .. '" data-runs="' .. runs .. '"' or
    small and ' class="live small" data-small="' .. name .. '" data-wants="' .. (hash_of(name) or '') .. '"' ..
      (image.attributes.dial and ' data-dial="' .. image.attributes.dial .. '"' or '') ..
      (image.attributes.set and ' data-set="' .. image.attributes.set .. '"' or '') .. (is_first and ' data-first' or '') or
    still and ' class="moving" data-moving="' .. path .. '"' or folder == 'live' and ' class="live" data-live="' .. name .. '" data-wants="' .. (hash_of(name) or '') .. '"' or ''
  if small then seen = seen + 1 end
  local caption = html_of(image.caption)
  local source = path:gsub('%.%a+$', '.c')
  local program = io.open(source) and place_of_file(source)
  if program and not small then
    caption = caption .. ' <a class="program" href="' .. program .. '">' .. name .. '.c</a>'
  end
  local picture = pandoc.Image({ pandoc.Str(pandoc.utils.stringify(image.caption)) },
    FORMAT:match('^epub') and not still and path or shown, '',
    { width = wide and string.format('%.0f', wide), height = high and string.format('%.0f', high),
      loading = not whole and not is_first and 'lazy' or nil })
  -- On dark paper a painting has another light.
  local dark = path:gsub('%.%a+$', '-dark.webp')
  local shade = not whole and io.open(dark)
  if shade then
    shade:close()
    local first = still and dark:gsub('%.webp$', '-still.webp') or dark
    picture = pandoc.Span({
      raw('<picture><source media="(prefers-color-scheme: dark)" srcset="' .. first .. '">'),
      picture, raw('</picture>') })
    if still then data = data .. ' data-dark="' .. dark .. '"' end
  end
  -- A phone gets the chart as phone.mjs lays it out.
  local narrow = not whole and path:match('%.svg$') and path:gsub('%.svg$', '-phone.svg')
  if narrow then
    local w, h = size((os.getenv('BUILD') or 'build') .. '/site/' .. narrow)
    picture = pandoc.Span({
      raw('<picture><source media="(max-width: 40rem)" srcset="' .. narrow .. '"' .. (w and ' width="' .. w .. '" height="' .. h .. '"' or '') .. '>'),
      picture, raw('</picture>') })
  end
  -- By itself it can be looked at as large as it is.
  if not whole and folder ~= 'live' and not still then picture = pandoc.Link({ picture }, shown) end
  local out = pandoc.List({
    block('<figure id="' .. (small and 'see-' .. seen .. '-' or 'figure-') .. name .. '"' .. data .. '>'), pandoc.Plain({ picture }),
  })
  -- What an EPUB's caption links to is in another of its files: pandoc knows in which.
  if FORMAT:match('^epub') then out:extend({ block('<figcaption>'), pandoc.Plain(image.caption), block('</figcaption></figure>') })
  else out:insert(block('<figcaption>' .. caption .. '</figcaption></figure>')) end
  return out
end

-- The link that stands alone over a piece of code or a table; over pieces of the
-- little program that share a block, a link each.
local function caption_in(para)
  if para.t ~= 'Para' then return nil end
  for _, one in ipairs(para.content) do
    if one.t ~= 'Link' and one.t ~= 'Span' and one.t ~= 'SoftBreak' then return nil end
  end
  local text = pandoc.utils.stringify(para.content)
  if text:match('^[%w_/.-]+, lines? %d') or text:match('^[%w_/.-]+%.csv') then
    -- A file is named once.
    local last
    local html = html_of(para.content):gsub('>([%w_/.-]+),%s+(lines? )', function(file, lines)
      local again = file == last
      last = file
      return again and '>' .. lines
    end)
    return { text = text, html = html }
  end
end

local function scrolled(table) return { block('<div class="table">'), table, block('</div>') } end

local function Blocks(list)
  local out = pandoc.List()
  local i = 1
  while i <= #list do
    local one, two = list[i], list[i + 1]
    local caption = two and caption_in(one)
    if caption and two.t == 'CodeBlock' then
      out:insert(piece_of(caption, two)); i = i + 1
    elseif caption and two.t == 'Table' then
      out:extend({ block('<figure class="data"><figcaption>' .. caption.html .. '</figcaption>') })
      out:extend(scrolled(tidy(two))); out:insert(block('</figure>')); i = i + 1
    elseif one.t == 'Table' then out:extend(scrolled(tidy(one)))
    elseif one.t == 'CodeBlock' then out:insert(block(code(one)))
    elseif picture_in(one) then out:extend(figure_of(picture_in(one)))
    else out:insert(one) end
    i = i + 1
  end
  return out
end

-- --- the page ---------------------------------------------------------------------

-- The files of a page that is only code: where each begins.
local function files_of(blocks)
  local out, last = {}, nil
  for _, para in ipairs(blocks) do
    local caption = caption_in(para)
    local file, line = (caption and caption.text or ''):match('([%w_.-]+), lines? (%d+)')
    if file and file ~= last then
      out[#out + 1] = '<li class="h2"><a href="#' .. file .. '-L' .. line .. '">' .. file .. '</a></li>'
      last = file
    end
  end
  return out
end

-- The list of a page's headings; each becomes a link to itself.
local function side_of(blocks)
  local out = {}
  for _, header in ipairs(blocks) do
    if header.t == 'Header' and (header.level == 2 or header.level == 3) then
      local link = '<a href="#' .. header.identifier .. '">' .. html_of(header.content) .. '</a>'
      out[#out + 1] = '<li class="h' .. header.level .. '">' .. link .. '</li>'
      header.content = { raw(whole and html_of(header.content) or link) }
    end
  end
  if #out == 0 then out = files_of(blocks) end
  return '<ol>' .. table.concat(out, '\n') .. '</ol>'
end

-- The title, with its number in a place of its own.
local function title_of(header)
  local number, title = pandoc.utils.stringify(header.content):match('^(%d%d%l?)%. (.*)')
  if number then header.content = { raw('<span class="number">' .. number .. '</span> ' .. title) } end
  return number
end

-- Quotes as a printer sets them: what opens a word opens, all others close, and so does
-- an apostrophe.
local function quotes(list)
  for i, inline in ipairs(list) do
    local before = list[i - 1]
    local opens = not before or before.t == 'Space' or before.t == 'SoftBreak' or before.t == 'Str' and before.text:match('%($')
    if inline.t == 'Str' then
      local text = inline.text
      if opens then text = text:gsub('^(%(?)"', '%1“'):gsub("^(%(?)'", '%1‘') end
      list[i] = pandoc.Str((text:gsub('"', '”'):gsub("'", '’')))
    end
  end
  return list
end

-- The page in which the little program is written has a name in the text.
local function Emph(words)
  if workshop and not whole and written ~= 'little' and pandoc.utils.stringify(words) == 'Your engine' then return pandoc.Link({ words }, 'little.html') end
end

local filter = { Link = Link, Emph = Emph, Inlines = Inlines, Math = Math, Blocks = Blocks }
local function chapter(blocks, meta)
  if whole then page = names.page[pandoc.utils.stringify(blocks[1].content)] end
  blocks = pandoc.walk_block(pandoc.Div(blocks), { Inlines = quotes }).content
  taken = anchor(blocks, whole and (page:match('^%d%d%l?%-') or page .. '-') or '', page)
  if whole then blocks[1].identifier = page end
  if not meta.home and not meta.write then
    meta.side = pandoc.MetaBlocks({ block(side_of(blocks)) })
    meta['side-title'] = page and page:match('^%d') and 'In this chapter' or 'On this page'
  end
  local live = blocks:filter(is_live)
  meta.live = #live > 0 or meta.home
  -- The picture of a card that is passed on.
  meta.card = (live[1] and picture_in(live[1]).src or 'figures/live/canopy.webp'):gsub('^%.%./%.%./', '')
  title_of(blocks[1])
  return pandoc.walk_block(pandoc.Div(blocks), filter).content
end

function Pandoc(doc)
  whole = doc.meta.whole
  volume = doc.meta.volume and pandoc.utils.stringify(doc.meta.volume)
  written = doc.meta.write and pandoc.utils.stringify(doc.meta.write)
  page = doc.meta.page and pandoc.utils.stringify(doc.meta.page)
  local out, blocks = pandoc.List(), pandoc.List()
  for i, one in ipairs(doc.blocks) do
    blocks:insert(one)
    local next = doc.blocks[i + 1]
    if not next or next.t == 'Header' and next.level == 1 then
      out:extend(chapter(blocks, doc.meta))
      blocks = pandoc.List()
    end
  end
  return pandoc.Pandoc(out, doc.meta)
end

return { { Pandoc = Pandoc } }
