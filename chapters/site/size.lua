-- size.lua - how wide and how high a picture is, from its first bytes: PNG, WebP,
-- SVG.  A page that knows it beforehand does not jump when the picture comes.

local function little(s, at, n)
  local sum = 0
  for i = n - 1, 0, -1 do sum = sum * 256 + s:byte(at + i) end
  return sum
end

return function(path)
  local file = io.open(path, 'rb')
  if not file then return nil end
  local head = file:read(1000)
  file:close()
  if head:sub(2, 4) == 'PNG' then return string.unpack('>I4I4', head, 17) end
  if head:sub(9, 12) == 'WEBP' then
    local kind = head:sub(13, 16)
    if kind == 'VP8X' then return little(head, 25, 3) + 1, little(head, 28, 3) + 1 end
    if kind == 'VP8 ' then return little(head, 27, 2) & 0x3fff, little(head, 29, 2) & 0x3fff end
    local bits = little(head, 22, 4)
    return (bits & 0x3fff) + 1, (bits >> 14 & 0x3fff) + 1
  end
  local _, _, wide, high = head:match('viewBox="%s*(%S+)%s+(%S+)%s+(%S+)%s+([^%s"]+)')
  return tonumber(wide), tonumber(high)
end
