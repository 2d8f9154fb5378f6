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

-- The caption of a block of code: a class of its own.  The page has no lib/
-- beside it, so the link becomes a plain name.
function Link(l)
  if l.target:match('^lib/.*#L%d') then
    return pandoc.Span(l.content, { class = 'place' })
  end
end
