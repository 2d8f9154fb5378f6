-- code.lua - a piece of code as HTML, with four colours: words of the language, values,
-- strings, notes.

local function set(words, class, into)
  for word in words:gmatch('%S+') do into[word] = class end
  return into
end
-- Of each language its words, and what opens a note.
local c = set('bool char double float int long short signed size_t unsigned void', 'dt',
  set('break case const continue default do else enum extern for goto if inline register restrict return sizeof static struct switch typedef union volatile while', 'kw', {}))
local languages = {
  c = { words = c, note = '^//.*' },
  sh = { words = set('case do done elif else esac fi for if in then while', 'kw', {}), note = '^#.*' },
  python = { words = set('as def else for from if import in return while with', 'kw', {}), note = '^#.*' },
}

local escapes = { ['&'] = '&amp;', ['<'] = '&lt;', ['>'] = '&gt;' }
local function escaped(text) return (text:gsub('[&<>]', escapes)) end

-- What stands in a line from `at` on: its end, and its class.
local function token_at(line, at, language)
  local function found(pattern)
    local _, last = line:find(pattern, at)
    return last
  end
  local last = found(language.note)
  if last then return last, 'co' end
  last = found('^[%a_][%w_]*')
  if last then return last, language.words[line:sub(at, last)] end
  last = found('^0[xX]%x[%x.]*[pP]?[+-]?%w*') or found('^%.?%d[%d.]*[eE][+-]?%w+') or found('^%.?%d[%w.]*')
  if last then return last, 'dv' end
  for _, quote in ipairs({ '"', "'" }) do
    if line:sub(at, at) == quote then
      last = at + 1
      while last < #line and line:sub(last, last) ~= quote do last = last + (line:sub(last, last) == '\\' and 2 or 1) end
      return last, 'st'
    end
  end
  return at
end

-- The command of the preprocessor that a line opens with, and the header that it names.
local function command_of(line)
  local command, rest = line:match('^(%s*#%s*%a+)(.*)$')
  if not command then return '', line end
  local header, after = rest:match('^(%s*<[^>]*>)(.*)$')
  return '<span class="pp">' .. command .. '</span>' .. (header and '<span class="st">' .. escaped(header) .. '</span>' or ''), after or rest
end

local function coloured(line, language)
  local out, at = {}, 1
  if language.words == c then out[1], line = command_of(line) end
  while at <= #line do
    local last, class = token_at(line, at, language)
    local text = escaped(line:sub(at, last))
    out[#out + 1] = class and '<span class="' .. class .. '">' .. text .. '</span>' or text
    at = last + 1
  end
  return table.concat(out)
end

-- `name` gives a line of C its anchor, or nil.
return function(block, name)
  local language, out = languages[block.classes[1]], {}
  for line in (block.text:gsub('\n+$', '') .. '\n'):gmatch('([^\n]*)\n') do
    local html, id = language and coloured(line, language) or escaped(line), name and name(line)
    out[#out + 1] = id and '<span id="' .. id .. '">' .. html .. '</span>' or html
  end
  return '<pre><code>' .. table.concat(out, '\n') .. '</code></pre>'
end
