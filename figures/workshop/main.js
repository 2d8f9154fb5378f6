// main.js - the workshop of a page: the reader's own C, written, compiled, judged and
// run where it is read.  <div data-exercise="01-step"> becomes a desk.

import style from './workshop.css';
import { openExercise } from './exercise.js';
import { make } from './desk.js';

document.head.append(make('style', {}, style));
for (const place of document.querySelectorAll('[data-exercise]'))
  openExercise(place).catch(error => { place.dataset.failed = error.message; place.append(make('p', {}, error.message)); });
