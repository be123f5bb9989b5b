import { startFirstRequests } from "./first_answers";

// main.tsx imports this first: evaluating the editor takes longer than the server's responses.
startFirstRequests();
