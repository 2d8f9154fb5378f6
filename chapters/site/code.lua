-- code.lua - a piece of code as HTML: coloured by pandoc, without its links and
-- names for each line, and without the colours that the page does not use.

local coloured = { kw = 1, cf = 1, dt = 1, dv = 1, fl = 1, bn = 1, cn = 1, st = 1, ch = 1,
                   sc = 1, im = 1, co = 1, pp = 1 }

local function plain(class, text)
  if not coloured[class] then return text end
end

-- `name` gives a line of C its anchor, or nil.
return function(block, name)
  if #block.classes == 0 then block = pandoc.CodeBlock(block.text, { class = 'default' }) end
  local html = pandoc.write(pandoc.Pandoc({ block }), 'html')
  local code = html:match('<code[^>]*>(.*)</code>')
  local out, source = {}, block.text:gmatch('([^\n]*)\n?')
  for line in (code .. '\n'):gmatch('([^\n]*)\n') do
    line = line:gsub('^<span id="cb[%d-]+">(.*)</span>$', '%1'):gsub('^<a href="#cb[^>]*></a>', '')
    line = line:gsub('<span class="(%w+)">([^<]*)</span>', plain)
    local id = name and name(source())
    out[#out + 1] = id and '<span id="' .. id .. '">' .. line .. '</span>' or line
  end
  return '<pre><code>' .. table.concat(out, '\n') .. '</code></pre>'
end
