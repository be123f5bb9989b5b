import * as Blockly from "blockly/core";
import { beforeAll, describe, expect, test } from "vitest";
import type { Language } from "../../i18n";
import { registerBlocks } from "..";
import { setBlockLanguage } from "../texts";
import { searchBlocks } from "./search";

beforeAll(registerBlocks);

/** Words that pupils search for, by the block that must be found. */
const SEARCH_TERMS: Readonly<Record<string, Readonly<Record<string, string>>>> = {
  "pt-BR": {
    move_forward: "andar, frente, avançar, reto, mover",
    move_backward: "ré, trás, voltar, recuar",
    turn: "girar, virar, rodar, ângulo, meia volta",
    stop: "parar, freio",
    arc: "curva, círculo, arco",
    go_to: "coordenada, desviar",
    set_speed_linear: "velocidade, devagar, rápido",
    drive: "acelerar, motor",
    repeat: "repetir, loop, laço",
    forever: "para sempre, infinito",
    until: "até que",
    while: "enquanto",
    wait: "esperar, pausa",
    if: "se, senão",
    compare: "igual",
    classify_gestures: "libras, sinal, câmera, mão, gesto",
    set_gesture_result: "fingir",
    distance_sensor: "parede, distância",
    bumper: "bateu, batida",
    floor: "cor, chão",
    pen_down: "desenhar, riscar, pintar, caneta",
    say: "falar, escrever, mostrar",
    beep: "som, buzina",
    mark: "xis, jogo da velha",
    go_to_place: "lugar, casa, tabuleiro",
    mark_value: "símbolo",
    has_mark: "ocupada, livre",
    mark_here: "ocupada",
    replace_item: "substituir, trocar",
    contains: "procurar, contém",
    position_of: "posição, onde",
    ask: "perguntar",
    set_variable: "variável, guardar",
    random_int: "sorteio, aleatório, dado",
    arithmetic: "conta, dividir",
    function_def: "função",
  },
  en: {
    move_forward: "forward, go, walk",
    move_backward: "reverse, back",
    turn: "turn, rotate, spin, angle",
    stop: "stop, brake",
    arc: "curve, circle",
    go_to: "coordinates, avoid",
    set_speed_linear: "speed, slow",
    repeat: "loop",
    forever: "forever",
    until: "until",
    while: "while",
    wait: "wait, sleep",
    if: "if",
    compare: "equals, greater",
    classify_gestures: "camera, hand",
    distance_sensor: "wall",
    bumper: "crash",
    floor: "color",
    pen_down: "draw, pen",
    say: "print, speak",
    beep: "sound",
    ask: "input",
    set_variable: "variable",
    random_int: "random, dice",
  },
  es: {
    move_forward: "avanzar, adelante, caminar",
    move_backward: "retroceder, atrás",
    turn: "girar, doblar, ángulo",
    stop: "parar, frenar",
    arc: "curva, círculo",
    go_to: "coordenadas, esquivar",
    set_speed_linear: "velocidad, lento",
    repeat: "repetir, bucle",
    forever: "siempre",
    until: "hasta que",
    while: "mientras",
    wait: "esperar, pausa",
    if: "si, sino",
    compare: "igual",
    classify_gestures: "seña, mano",
    distance_sensor: "pared",
    bumper: "choque",
    floor: "color",
    pen_down: "dibujar, lápiz",
    say: "decir, mostrar",
    beep: "sonido",
    ask: "preguntar",
    set_variable: "variable",
    random_int: "azar, dado",
  },
};

const cases = (language: Language) =>
  Object.entries(SEARCH_TERMS[language] ?? {}).flatMap(([type, terms]) =>
    terms.split(", ").map((term): [string, string] => [term, type]),
  );

const folded = (term: string) => term.normalize("NFD").replace(/\p{M}/gu, "").toUpperCase();

describe.each(Object.keys(SEARCH_TERMS))("in %s", (language) => {
  test.each(cases(language))("%s finds %s among the first three", (term, type) => {
    setBlockLanguage(language);
    for (const typed of [term, folded(term)]) {
      const found = searchBlocks(typed, 3, new Blockly.Workspace());
      expect(found.slice(0, 3).map((block) => block.type)).toContain(type);
    }
  });
});

test("the words are counted, so that none gets lost", () => {
  expect(Object.keys(SEARCH_TERMS).map((language) => cases(language).length)).toEqual([83, 40, 40]);
});
