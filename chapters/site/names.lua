-- names.lua - where what the book names is told of: the pages by their titles, the
-- chapters, their figures, and the pieces of code in which functions and types
-- stand.  It reads the woven pages; page.lua makes links of it.

local names = { chapter = {}, page = {}, figure = {}, code = {} }
local folder = 'chapters/woven'

-- In `code` each name has the pages that define it: [page] = file.
local function tell(name, page, file)
  local places = names.code[name] or {}
  names.code[name] = places
  -- A definition is a better place than a declaration.
  if not places[page] or places[page]:match('%.h$') then places[page] = file end
end

local function read(page)
  local number = page:match('^%d%d%l?')
  for line in io.lines(folder .. '/' .. page .. '.md') do
    local title = line:match('^# (.*)')
    if title then names.page[title] = page end
    if title and number then names.chapter[number] = { page = page, title = title } end
    local figure = line:match('^!%[.*%]%(%.%./%.%./figures/.*/([^/]*)%.%a+%)$')
    if figure then names.figure[figure] = page end
    local file, all = line:match('^%[(%S*), lines? [%d to]*: (.*)%]%(')
    if file then
      for name in all:gmatch('[%w_]+') do tell(name, page, file) end
    end
  end
end

for file in io.popen('ls ' .. folder):lines() do
  read(file:match('(.*)%.md$'))
end

-- The page and the file that a name means when `page` says it: its own, or the
-- one other page that has it.
function names.place(name, page)
  local places = names.code[name]
  if not places then return nil end
  if places[page] then return page, places[page] end
  local best, file, count
  for other, where in pairs(places) do
    local is_definition = where:match('%.c$') ~= nil
    if not best or is_definition and not file:match('%.c$') then
      best, file, count = other, where, 1
    elseif is_definition == (file:match('%.c$') ~= nil) then
      count = count + 1
    end
  end
  if count == 1 then return best, file end
end

-- The name of the element that holds it: the function's own name, or where several
-- files have one of that name, their module's before it.
function names.id(name, file)
  local files = {}
  for _, where in pairs(names.code[name]) do files[where:gsub('%.[ch]$', '')] = true end
  local first = next(files)
  if next(files, first) == nil then return name end
  return file:match('([%w_]+)%.[ch]$') .. '-' .. name
end

return names
