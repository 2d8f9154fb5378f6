-- search.lua - what a search looks through, as a script: a row for each section of
-- each page (page, anchor, heading, words), and one for each function and type.

local here = 'chapters/site/'
local names = dofile(here .. 'names.lua')
local anchor = dofile(here .. 'headings.lua')

local function quoted(s)
  return '"' .. s:gsub('[%c\\"]', { ['"'] = '\\"', ['\\'] = '\\\\' }):gsub('%c', ' ') .. '"'
end
local rows = {}
local function row(...)
  local cells = {}
  for i, cell in ipairs({ ... }) do cells[i] = quoted(cell) end
  rows[#rows + 1] = '[' .. table.concat(cells, ',') .. ']'
end

-- A formula as it is read, without the signs of its notation.
local function formula(math)
  return pandoc.Str((math.text:gsub('\\[,;:! ]', ' '):gsub('[\\{}]', '')))
end
-- The points of a list are parted by spaces.
local function point(plain)
  plain.content:insert(pandoc.Space())
  return plain
end

-- The words of a section: no code and no tables, and no captions of code.
local function words(block)
  if block.t == 'CodeBlock' or block.t == 'Table' then return '' end
  local text = pandoc.utils.stringify(block:walk({ Math = formula, Plain = point, Para = point }))
  return text:match('^[%w_/.-]+, lines? %d') and '' or text
end

local function sections(blocks)
  local title = pandoc.utils.stringify(blocks[1].content)
  local page = names.page[title] or 'exercises'
  anchor(blocks, '')
  local head, text = blocks[1], {}
  local function close()
    local own = head.level == 1 and title or pandoc.utils.stringify(head.content)
    row(page, head.level == 1 and '' or head.identifier, own, table.concat(text, ' '))
  end
  for i = 2, #blocks do
    local block = blocks[i]
    if block.t == 'Header' then close(); head, text = block, {}
    else text[#text + 1] = words(block) end
  end
  close()
end

function Pandoc(doc)
  local blocks = pandoc.List()
  for i, one in ipairs(doc.blocks) do
    blocks:insert(one)
    local next = doc.blocks[i + 1]
    if not next or next.t == 'Header' and next.level == 1 then sections(blocks); blocks = pandoc.List() end
  end
  local all = {}
  for name in pairs(names.code) do all[#all + 1] = name end
  table.sort(all)
  for _, name in ipairs(all) do
    local page, file = names.place(name, '')
    if page then row(page, names.id(name, file), name, file:match('[^/]*$')) end
  end
  return pandoc.Pandoc({ pandoc.RawBlock('plain', 'window.sections=[\n' .. table.concat(rows, ',\n') .. '];') })
end
