// begin.js - the place where all scripts of the workshop leave what they bring.

(window.tumble ||= {}).workshop ||= {};
