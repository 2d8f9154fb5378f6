-- names.lua - where what the book names is told of: the pages by their titles, the
-- chapters, their figures, and the pieces of code in which functions and types
-- stand.  names.awk has found them in the woven pages; page.lua makes links of it.

local names = { chapter = {}, page = {}, figure = {}, code = {} }

-- In `code` each name has the pages that define it: [page] = file.
local function tell(name, page, file)
  local places = names.code[name] or {}
  names.code[name] = places
  -- A definition is a better place than a declaration.
  if not places[page] or places[page]:match('%.h$') then places[page] = file end
end

for line in io.lines((os.getenv('BUILD') or 'build') .. '/names') do
  local page, kind, what = line:match('^([^\t]*)\t([^\t]*)\t(.*)')
  local number = page:match('^%d%d%l?')
  if kind == 'title' then names.page[what] = page end
  if kind == 'title' and number then names.chapter[number] = { page = page, title = what } end
  if kind == 'figure' then names.figure[what] = page end
  local file, all = what:match('^(%S*)\t(.*)')
  for name in (all or ''):gmatch('[%w_]+') do tell(name, page, file) end
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
