// main.js - the workshop of a page: the reader's own C, written, compiled, judged and
// run where it is read.  <div data-exercise="01-step"> becomes a
// desk, and so does <div data-little>.

import style from './workshop.css';
import { openExercise } from './exercise.js';
import { openLittle } from './little.js';
import { make } from './node.js';

document.head.append(make('style', {}, style));
const open = (where, how) => document.querySelectorAll(where).forEach(place =>
  how(place).catch(error => { place.dataset.failed = error.message; place.append(make('p', {}, error.message)); }));
open('[data-exercise]', openExercise);
open('[data-little]', openLittle);
