-- formula.lua - a formula of TeX as MathML that a narrow page may break: before a
-- relation, in a display also before a plus or minus and after a comma, but not
-- within brackets or groups.  What much space parts is a formula of its own.

local relation = { ['='] = true, ['<'] = true, ['>'] = true }
for word in ('approx le ge leq geq ne equiv to iff propto sim'):gmatch('%a+') do relation['\\' .. word] = true end
local opens = { ['{'] = 1, ['('] = 1, ['\\left'] = 1, ['\\begin'] = 1,
  ['}'] = -1, [')'] = -1, ['\\right'] = -1, ['\\end'] = -1 }
local LONG = 45              -- signs of a formula in a line that may be broken
local space = { ['\\quad'] = true, ['\\qquad'] = true }

-- One token of TeX; \left and \right with their bracket.
local function token_at(tex, at)
  return tex:match('^\\left%s*\\?.', at) or tex:match('^\\right%s*\\?.', at) or
    tex:match('^\\%a+', at) or tex:match('^\\.', at) or tex:sub(at, at)
end

-- The formulas of a display, each a list of its pieces.
local function pieces(tex, is_display)
  local all, depth, at = { { '' } }, 0, 1
  while at <= #tex do
    local token, out = token_at(tex, at), all[#all]
    local before = out[#out]
    depth = depth + (opens[token:match('^\\%a+') or token] or 0)
    local is_sign = is_display and token:match('^[+-]$') and before:gsub('\\[;,:!]', ''):match('[%w})|]%s*$')
    if depth == 0 and space[token] then
      all[#all + 1] = { '' }; token = token .. (tex:match('^%s+', at + #token) or '')
    elseif depth == 0 and before:match('%S') and (relation[token] or is_sign) then out[#out + 1] = token
    elseif depth == 0 and token == ',' and is_display then out[#out] = before .. token; out[#out + 1] = ''
    else out[#out] = before .. token end
    at = at + #token
  end
  return all
end

-- A sign that combines with the one before it has no width, and none of its own place
-- over a letter: here stands the one that does.
local stands_alone = { ['\u{307}'] = '\u{2d9}', ['\u{308}'] = '\u{a8}', ['\u{303}'] = '\u{2dc}' }

-- After these a minus is the sign of what follows, and stands close to it.
local comes_before_a_sign = {}
for sign in ('= &lt; &gt; ≤ ≥ ≈ ( [ ,'):gmatch('%S+') do comes_before_a_sign[sign] = true end

-- As in TeX, a bracket grows only after \left, the letter l is no operator, and what
-- opens a piece stands between two others.  No browser shows TeX.
local function piece_of(tex, is_first, to_html)
  local html = to_html(tex):gsub('<annotation.-</annotation>', ''):gsub('</?semantics>', '')
  if FORMAT:match('^html') then html = html:gsub(' xmlns="[^"]*"', '') end
  html = html:gsub('<mover>(.-)<mo accent="true">([^<]*)</mo>', function(under, sign)
    return '<mover accent="true">' .. under .. '<mo>' .. (stands_alone[sign] or sign) .. '</mo>'
  end)
  html = html:gsub('<mo>%+</mo><mo>=</mo>', '<mo>+=</mo>')
  html = html:gsub('(<mo[^>]*>([^<]*)</mo>)<mo>−</mo>', function(before, sign)
    return comes_before_a_sign[sign] and before .. '<mo form="prefix">−</mo>'
  end)
  if not tex:match('\\left') then html = html:gsub('stretchy="true"', 'stretchy="false"') end
  if not is_first then html = html:gsub('<mrow><mo>', '<mrow><mo form="infix">', 1) end
  html = html:gsub('<mo>ℓ</mo>', '<mi>ℓ</mi>')
  html = html:gsub('<mo>(%a%a%a+)</mo>(<mo stretchy="false">%()', '<mo lspace="0" rspace="0">%1</mo>%2')
  return (html:gsub('<mo>(%a%a%a+)</mo>', '<mo lspace="0" rspace="0.17em">%1</mo>'))
end

-- to_html(tex) is the MathML of a formula in a line.
return function(tex, is_display, to_html)
  if not is_display and #tex < LONG then return piece_of(tex, true, to_html) end
  local all = pieces(tex, is_display)
  for i, list in ipairs(all) do
    for k, one in ipairs(list) do
      list[k] = piece_of(one, k == 1, to_html)
      if is_display then list[k] = list[k]:gsub('display="inline"', 'displaystyle="true"') end
    end
    all[i] = table.concat(list, '<wbr/>')
  end
  if not is_display then return table.concat(all, ' ') end
  return '<span class="formula"><span>' .. table.concat(all, '</span> <span>') .. '</span></span>'
end
