-- book.lua - what pandoc needs to be told to make a page of the book.

-- A picture that stands alone becomes a figure, its text the caption.
function Para(p)
  local image = p.content[1]
  if #p.content ~= 1 or image.t ~= 'Image' then return nil end
  local caption = pandoc.write(pandoc.Pandoc({pandoc.Plain(image.caption)}),
                               'html', { html_math_method = 'mathml' })
  local plain = pandoc.utils.stringify(image.caption):gsub('"', '&quot;')
  return {
    pandoc.RawBlock('html', '<figure>'),
    pandoc.Plain({ pandoc.Image({ pandoc.Str(plain) }, image.src) }),
    pandoc.RawBlock('html', '<figcaption>' .. caption .. '</figcaption></figure>'),
  }
end

-- The caption of a block of code or a table: a class of its own.  The page has
-- no tree beside it, so the link becomes a plain name.
function Link(l)
  if not l.target:match('^%a+:') and not l.target:match('^#') then
    return pandoc.Span(l.content, { class = 'place' })
  end
end

-- A comma or a bracket stays on the line of the formula or name it belongs to.
function Inlines(list)
  for i = #list - 1, 1, -1 do
    local one, two = list[i], list[i + 1]
    if (one.t == 'Math' or one.t == 'Code') and two.t == 'Str' and two.text:match('^[%p]') then
      list[i] = pandoc.Span({ one, two }, { class = 'whole' })
      list:remove(i + 1)
    elseif one.t == 'Str' and one.text:match('%($') and (two.t == 'Math' or two.classes and two.classes[1] == 'whole') then
      list[i] = pandoc.Span({ one, two }, { class = 'whole' })
      list:remove(i + 1)
    end
  end
  return list
end
