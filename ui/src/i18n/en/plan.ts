import type { plan as first } from "../pt-BR/plan";

export const plan: typeof first = {
  title: "Two-hour lesson",
  about:
    "Two 50-minute periods, five groups. Each group programs its letter; at the end, a sign makes the robot draw it.",
  print: "Print",
  save: "Save as a file",
  saveHelp: "Saves a page that opens and prints in any browser",
  fileName: "lesson-plan",
  columns: { minutes: "min", teacher: "Teacher", groups: "Groups", screen: "Screen" },
  steps: {
    human: {
      minutes: "0–15",
      teacher: "“What does a robot vacuum cleaner obey?” Human robot: only “forward 1”, “turn 90”.",
      groups:
        "Give examples; dictate the way to the door: when it turns, the robot does not move ahead.",
      screen: "Example Vacuum cleaner",
    },
    alphabet: {
      minutes: "15–25",
      teacher:
        "Manual alphabet: A, B, E, L, S, T, seen from the front. Fingerspelling is spelling with it; it is not the sign of the word.",
      groups: "Copy it in pairs.",
      screen: "Large letters",
    },
    first: {
      minutes: "25–35",
      teacher: "First drive and activity 1.3.",
      groups: "Predict, run, compare.",
      screen: "Card, floor",
    },
    paper: {
      minutes: "35–50",
      teacher:
        "Hands out paper and cut-out cards (move, turn, repeat, pen, read sign, if; the number is written in pencil).",
      groups: "Plan the letter (2.6); one of them plays the robot and follows the plan.",
      screen: "Off",
    },
    blocks: {
      minutes: "50–70",
      teacher: "Walks around: “Which block did that?”",
      groups: "Turn cards into blocks, run, swap roles.",
      screen: "Blocks and floor",
    },
    decide: {
      minutes: "70–75",
      teacher: "“First read, then decide.”",
      groups: "Add “read sign” and “if”.",
      screen: "Activity 3.1",
    },
    show: {
      minutes: "75–92",
      teacher: "One group at a time: sign, robot, the class reads.",
      groups: "Explain one repair (“10° more in the last turn”).",
      screen: "Robot or projector",
    },
    talk: {
      minutes: "92–100",
      teacher:
        "“Is it closed? Symmetric? Did it return? What was hard: angle, distance, order, the moment of the sign?”",
      groups: "One sentence each.",
      screen: "Lines of the lesson",
    },
  },
  robots:
    "One real robot: 3 min for each group, 1 m of tape on the floor, a hand on Stop. Without a robot: the projector shows the floor.",
  deaf: {
    title: "With deaf pupils",
    points: [
      "Translator-interpreter of Libras (TILS) and screen side by side; each pupil sees the face of who speaks and the TILS; one person speaks at a time.",
      "The script of the lesson reaches the TILS two days before. Signs agreed on before: robot, turn, repeat, repair.",
      "The light stays on while the projector is used.",
      "There is time to look: nobody looks at the screen and at the TILS at once.",
      "The written language is a second language: whole, short sentences, cards with the hand drawn on them.",
      "What the robot says stays in writing; a beep is seen too, and no clue is sound alone.",
      "A deaf pupil may teach the class the manual alphabet, if they want to; interpreting for classmates is not their task.",
    ],
  },
  projector: {
    title: "One PC and a projector",
    points: [
      "Plans on paper.",
      "One group builds, the others predict with their fingers (1–4).",
      "They swap every 6 min, and the next group repairs.",
    ],
  },
  roles:
    "In each group everybody acts: pilot, reader, path inspector, signer. They swap every ten minutes.",
  open: (activity) => `Open ${activity} for the class`,
  isOpen: (activity) => `${activity} is open for the class`,
  noClass: "To open an activity from here, make a class first.",
  links: { cards: "Cards to cut out", letters: "Practise letters and signs", lessons: "Lessons" },
  cards: {
    title: "Cards to cut out",
    about: "Real blocks, with room to write the values in pencil.",
    back: "Lesson plan",
    which: "Which",
    lists: {
      lesson: "Of the two-hour lesson",
      level1: "Level 1",
      level2: "Level 2",
      level3: "Level 3: all",
      letters: "Letters of the manual alphabet: A, B, E, L, S, T",
    },
    copies: "Of each",
    ink: "Colour",
    inks: { lines: "Black on white", colours: "In colours" },
    sheet: "Cards",
    drawing: "Drawing the cards…",
    fileName: "cards",
    printHelp:
      "A4 paper. If there is no printer here, save as a file and open it in a browser on another PC.",
  },
};
