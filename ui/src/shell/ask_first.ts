import { askFirst } from "./first_answers";

// Evaluating the editor takes longer than an answer of the server: main.tsx imports this before everything else.
askFirst();
