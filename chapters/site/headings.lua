-- headings.lua - the anchor of each heading of a page: its words, and where two
-- sections, or the page and one of them, have one name, those of the section around
-- it as well.  That of an exercise is its name.

local function slug(header)
  local words = pandoc.utils.stringify(header.content):lower()
  local number, exercise = words:match('^(%d%d%l?)/([%w-]+):')
  if number then return number .. '-' .. exercise end
  return (words:gsub('[^%w%s_-]', ''):gsub('%s+', '-'):gsub('^-+', ''):gsub('-+$', ''))
end

return function(blocks, prefix, page)
  local seen, above = { [page or ''] = true }, page or ''
  for _, block in ipairs(blocks) do
    if block.t == 'Header' then
      local id = prefix .. slug(block)
      if seen[id] then id = above .. '-' .. slug(block) end
      while seen[id] do id = id .. '-again' end
      seen[id] = true
      if block.level <= 2 then above = id end
      block.identifier = id
    end
  end
  return seen
end
