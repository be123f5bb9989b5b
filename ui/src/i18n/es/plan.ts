import type { plan as first } from "../pt-BR/plan";

export const plan: typeof first = {
  title: "Clase de dos horas",
  about:
    "Dos períodos de 50 minutos, cinco grupos. Cada grupo programa su letra; al final, una seña hace que el robot la dibuje.",
  print: "Imprimir",
  save: "Guardar como archivo",
  saveHelp: "Guarda una página que se abre e imprime en cualquier navegador",
  fileName: "plan-de-clase",
  columns: { minutes: "min", teacher: "Docente", groups: "Grupos", screen: "Pantalla" },
  steps: {
    human: {
      minutes: "0–15",
      teacher: "“¿A qué obedece una aspiradora robot?” Robot humano: solo “avanzar 1”, “girar 90”.",
      groups: "Dan ejemplos; dictan el camino hasta la puerta: al girar, el robot no avanza.",
      screen: "Ejemplo Aspiradora",
    },
    alphabet: {
      minutes: "15–25",
      teacher:
        "Alfabeto manual: A, B, E, L, S, T, vistas de frente. Dactilología es deletrear con él; no es la seña de la palabra.",
      groups: "Copian en parejas.",
      screen: "Letras grandes",
    },
    first: {
      minutes: "25–35",
      teacher: "Primer paseo y actividad 1.3.",
      groups: "Predicen, ejecutan, comparan.",
      screen: "Tarjeta, piso",
    },
    paper: {
      minutes: "35–50",
      teacher:
        "Da papel y tarjetas recortadas (avanzar, girar, repetir, lápiz, leer seña, si; el número se escribe a lápiz).",
      groups: "Planean la letra (2.6); un integrante hace de robot y sigue el plan.",
      screen: "Apagada",
    },
    blocks: {
      minutes: "50–70",
      teacher: "Circula: “¿Qué bloque hizo eso?”",
      groups: "Pasan las tarjetas a bloques, ejecutan, cambian de papel.",
      screen: "Bloques y piso",
    },
    decide: {
      minutes: "70–75",
      teacher: "“Primero leer, después decidir.”",
      groups: "Agregan “leer seña” y “si”.",
      screen: "Actividad 3.1",
    },
    show: {
      minutes: "75–92",
      teacher: "Un grupo por vez: seña, robot, el curso lee.",
      groups: "Explican un arreglo (“10° más en el último giro”).",
      screen: "Robot o proyector",
    },
    talk: {
      minutes: "92–100",
      teacher:
        "“¿Se cerró? ¿Es simétrica? ¿Volvió? Lo difícil: ¿ángulo, distancia, orden, momento de la seña?”",
      groups: "Una frase cada uno.",
      screen: "Líneas de la clase",
    },
  },
  robots:
    "Un robot de verdad: 3 min por grupo, cinta de 1 m en el piso, mano en Parar. Sin robot: el piso aparece en el proyector.",
  deaf: {
    title: "Con alumnos sordos",
    points: [
      "Traductor-intérprete de Libras (TILS) y pantalla lado a lado; cada alumno ve el rostro de quien habla y al TILS; habla una persona por vez.",
      "El guion de la clase le llega al TILS dos días antes. Señas acordadas antes: robot, girar, repetir, arreglo.",
      "La luz queda encendida durante la proyección.",
      "Hay tiempo para mirar: nadie mira la pantalla y al TILS al mismo tiempo.",
      "La lengua escrita es segunda lengua: frases enteras y cortas, tarjetas con la mano dibujada.",
      "Lo que dice el robot queda escrito; el pitido también se ve, y ninguna pista es solo sonora.",
      "El alumno sordo puede enseñar el alfabeto manual al curso, si quiere; no es tarea suya interpretar para sus compañeros.",
    ],
  },
  projector: {
    title: "Una computadora y proyector",
    points: [
      "Planes en papel.",
      "Un grupo arma, los otros predicen con los dedos (1–4).",
      "Cada 6 min se cambia, y el próximo arregla.",
    ],
  },
  roles:
    "En cada grupo todos actúan: piloto, lector, inspector del camino, señante. Cambian cada diez minutos.",
  open: (activity) => `Abrir ${activity} para el curso`,
  isOpen: (activity) => `${activity} está abierta para el curso`,
  noClass: "Para abrir una actividad desde aquí, cree antes un curso.",
  links: {
    cards: "Tarjetas para recortar",
    letters: "Practicar letras y señas",
    lessons: "Clases",
  },
  cards: {
    title: "Tarjetas para recortar",
    about: "Bloques de verdad, con espacio para escribir los valores a lápiz.",
    back: "Plan de clase",
    which: "Cuáles",
    lists: {
      lesson: "De la clase de dos horas",
      level1: "Nivel 1",
      level2: "Nivel 2",
      level3: "Nivel 3: todos",
      letters: "Letras del alfabeto manual: A, B, E, L, S, T",
    },
    copies: "De cada una",
    ink: "Color",
    inks: { lines: "Negro sobre blanco", colours: "En colores" },
    sheet: "Tarjetas",
    drawing: "Dibujando las tarjetas…",
    fileName: "tarjetas",
    printHelp:
      "Hoja A4. Si aquí no hay impresora, guarde como archivo y ábralo en un navegador de otra computadora.",
  },
};
