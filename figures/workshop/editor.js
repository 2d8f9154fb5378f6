// editor.js - the editor of the workshop: CodeMirror, in the colours of the page.

import { EditorState } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers } from '@codemirror/view';
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { bracketMatching, HighlightStyle, indentOnInput, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, lintKeymap, setDiagnostics } from '@codemirror/lint';
import { cpp } from '@codemirror/lang-cpp';
import { tags } from '@lezer/highlight';

const colours = HighlightStyle.define([
  { tag: [tags.keyword, tags.controlKeyword, tags.typeName, tags.standard(tags.typeName), tags.modifier], color: 'var(--word)' },
  { tag: [tags.number, tags.bool, tags.null, tags.processingInstruction, tags.macroName], color: 'var(--value)' },
  { tag: [tags.string, tags.character], color: 'var(--string)' },
  { tag: tags.comment, color: 'var(--note)', fontStyle: 'italic' },
]);

const look = EditorView.theme({
  '&': { backgroundColor: 'var(--code)', color: 'var(--ink)', fontSize: '.84375rem', height: '100%' },
  '.cm-content': { fontFamily: 'var(--mono)', caretColor: 'var(--ink)', padding: '.6rem 0' },
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '1.5' },
  '.cm-gutters': { backgroundColor: 'var(--code)', color: 'var(--quiet)', border: 'none' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'color-mix(in srgb, var(--ink) 6%, transparent)' },
  '.cm-cursor': { borderLeftColor: 'var(--ink)' },
  '&.cm-focused .cm-selectionBackground, .cm-selectionBackground, ::selection': { backgroundColor: 'color-mix(in srgb, var(--blue) 28%, transparent) !important' },
  '&.cm-focused': { outline: '2px solid var(--blue)', outlineOffset: '-2px' },
  '.cm-tooltip': { backgroundColor: 'var(--page)', color: 'var(--ink)', border: '1px solid var(--rule)', fontFamily: 'var(--sans)', fontSize: '.8125rem' },
  '.cm-diagnostic': { whiteSpace: 'pre-wrap' },
});

// An editor in `place` with that text.  changed() is called when the text is another,
// act() by Ctrl-Enter.  Tab leaves it, as it leaves any other field.
export function makeEditor(place, text, label, changed, act) {
  const view = new EditorView({
    parent: place,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(), highlightSpecialChars(), history(), drawSelection(), indentOnInput(), bracketMatching(), highlightActiveLine(), highlightActiveLineGutter(),
        cpp(), indentUnit.of('    '), EditorState.tabSize.of(4), syntaxHighlighting(colours), look, lintGutter(),
        keymap.of([{ key: 'Mod-Enter', run: () => { act(); return true; } }, ...defaultKeymap, ...historyKeymap, ...lintKeymap]),
        EditorView.contentAttributes.of({ 'aria-label': label, spellcheck: 'false', autocapitalize: 'off' }),
        EditorView.updateListener.of(update => { if (update.docChanged) changed(); }),
      ],
    }),
  });
  const lineAt = number => view.state.doc.line(Math.max(1, Math.min(number, view.state.doc.lines)));
  // Brings a place to the middle of the editor.  The page stays where it is: on a phone
  // the task stands above, and is read first.
  const centre = at => view.requestMeasure({
    read: () => view.lineBlockAt(at),
    write({ top, bottom }) { view.scrollDOM.scrollTop = (top + bottom - view.scrollDOM.clientHeight) / 2; },
  });
  return {
    get text() { return view.state.doc.toString(); },
    set text(text) { view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } }); },
    // [{ line, column, kind, text }]
    mark(messages) {
      view.dispatch(setDiagnostics(view.state, messages.map(({ line, column = 1, kind, text }) => {
        const at = lineAt(line), from = Math.min(at.from + column - 1, at.to);
        const word = view.state.wordAt(from);
        return { from, to: Math.max(word?.to ?? 0, from), severity: kind === 'note' ? 'info' : kind, message: text };
      })));
    },
    // Goes on where another field was left.
    take({ selectionStart: anchor, selectionEnd: head }, isToWrite) {
      view.dispatch({ selection: { anchor, head } });
      centre(head);
      if (isToWrite) view.focus();
    },
    // Brings a line to the middle, and the editor into view if the reader asked for it.
    show(line, isAsked) {
      const { from } = lineAt(line);
      view.dispatch({ selection: { anchor: from } });
      centre(from);
      if (isAsked) view.dom.scrollIntoView({ block: 'nearest' });
    },
  };
}

window.tumble.workshop.makeEditor = makeEditor;
