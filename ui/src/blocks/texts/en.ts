import type { BlockTexts } from "./keys";

export const en: BlockTexts = {
  CATEGORY_MOTION: "Motion",
  CATEGORY_FLOW: "Control",
  CATEGORY_LOGIC: "Logic",
  CATEGORY_GESTURES: "Gestures",

  PROGRAM_START: "%1 when run",
  PROGRAM_START_TIP: "The program starts here. The robot does what is attached below.",
  MOVE_FORWARD: "%1 move forward %2 m",
  MOVE_FORWARD_TIP: "The robot drives straight ahead, 0 to 100 metres.",
  MOVE_BACKWARD: "%1 move backward %2 m",
  MOVE_BACKWARD_TIP: "The robot drives straight back without turning, 0 to 100 metres.",
  TURN: "%1 turn %2 %3 °",
  TURN_TIP: "The robot turns on the spot, 0 to 360 degrees. A quarter turn is 90 degrees.",
  LEFT: "left",
  RIGHT: "right",
  STOP: "%1 stop",
  STOP_TIP: "The robot stops. Then it goes on with the next block.",

  REPEAT: "%1 repeat %2 times",
  REPEAT_TIP: "Does everything inside again and again, 1 to 1000 times.",
  WAIT: "%1 wait %2 s",
  WAIT_TIP: "The robot stands still for this time, 0 to 600 seconds.",

  IF: "%1 if %2 then",
  IF_TIP: "Does what is inside only if the condition is true.",
  IF_ELSE: "%1 if %2 then",
  IF_ELSE_TIP: "If the condition is true it does the first part; if not, the second.",
  ELSE: "else",
  COMPARE: "%1 %2 %3",
  COMPARE_TIP: "True if both sides are equal (=) or different (≠).",
  LOGIC_OPERATION: "%1 %2 %3",
  LOGIC_OPERATION_TIP: "“and”: both sides must be true. “or”: one of them is enough.",
  AND: "and",
  OR: "or",
  NOT: "not %1",
  NOT_TIP: "Swaps: true becomes false, false becomes true.",

  CLASSIFY_GESTURES: "%1 read gesture within %2 s",
  CLASSIFY_GESTURES_TIP:
    "Waits for someone to sign a LIBRAS letter to the camera and keeps it. 1 to 60 seconds.",
  GESTURE_RESULT: "gesture read",
  GESTURE_RESULT_TIP: "The letter of the last gesture. Empty if no gesture was recognised.",
  TEXT_LETTER: "%1",
  TEXT_LETTER_TIP: "A letter to compare with the gesture. Click to change it.",
  SET_GESTURE_RESULT: "%1 pretend the gesture is %2",
  SET_GESTURE_RESULT_TIP:
    "Keeps this letter as if it were a gesture. Good for testing without a camera.",

  HINT_EMPTY: "Drag a block here",
  OUT_OF_RANGE: "A number from %1 to %2 fits here. It is %3 now.",
  NOT_A_NUMBER: "Only a number fits here. It is %1 now.",
  ZOOM_IN: "Make the blocks larger",
  ZOOM_OUT: "Make the blocks smaller",
  ZOOM_TO_FIT: "Show the whole program",
  DECIMAL_SEPARATOR: ".",
};
