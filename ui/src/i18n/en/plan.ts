import type { plan as first } from "../pt-BR/plan";

export const plan: typeof first = {
  title: "A lesson of two hours",
  about:
    "Twice 50 minutes, five groups. Each group programs its letter; in the end, a sign calls it.",
  print: "Print",
  save: "Save as a file",
  saveHelp: "Saves a page that opens and prints in any browser",
  fileName: "lesson-plan",
  columns: { minutes: "min", teacher: "Teacher", groups: "Groups", screen: "Screen" },
  steps: {
    human: {
      minutes: "0–15",
      teacher: "“What does a robot vacuum cleaner obey?” Human robot: only “forward 1”, “turn 90”.",
      groups: "Give examples; dictate the way to the door: turning does not move ahead.",
      screen: "Example Vacuum cleaner",
    },
    alphabet: {
      minutes: "15–25",
      teacher: "Alphabet: A, B, E, L, S, T, seen from the front.",
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
        "Hands out paper and cut-out cards (move, turn, repeat, pen, read gesture, if; the number is in pencil).",
      groups: "Plan the letter (2.6); one of them walks the plan.",
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
      groups: "Put in read gesture and if.",
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
    "One real robot: 3 min for each group, 1 m of tape on the floor, a hand on Stop. None: the projector is the floor.",
  deaf: {
    title: "With a deaf pupil",
    points: [
      "Interpreter and screen side by side; one person speaks at a time.",
      "Signs agreed on before: robot, turn, repeat, repair.",
      "Cards with the hand drawn on them.",
      "What the robot says stays in writing; a beep is seen too, and no clue is sound alone.",
      "Teaches the alphabet if they want to, without becoming the interpreter.",
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
    "In each group everybody acts: pilot, reader, floor inspector, signer. They swap every ten minutes.",
  open: (activity) => `Open ${activity} for the class`,
  isOpen: (activity) => `${activity} is open for the class`,
  noClass: "To open an activity from here, make a class first.",
  links: { cards: "Cards to cut out", letters: "Practise signs", lessons: "Lessons" },
  cards: {
    title: "Cards to cut out",
    about: "Real blocks, with room to write the values in pencil.",
    back: "Lesson plan",
    which: "Which",
    lists: {
      lesson: "Of the lesson of two hours",
      level1: "Level 1",
      level2: "Level 2",
      level3: "Level 3: all",
      letters: "Signs A, B, E, L, S, T",
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
